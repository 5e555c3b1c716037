// Whether a part will stand while it is printed. It looks at one slice after another, from the bed
// up, and follows islands from layer to layer by where they overlap.
//
//      ┌──────┐        A body is what hangs together with one island on the bed. Where two meet,
//      │ body │        each has stood alone up to there, on its own foot (foothold.h); from there
//     ┌┴┐    ┌┴┐       on both stand on one foot: the hull of theirs.
//     │ │leg │ │leg
//     ┴─┴────┴─┴──     A column is a stretch of islands over one another that stay thin.
//
// What a column's tip gives way to a push F is  4 F h³ / (E t⁴),  t: the thickness of the square
// column that bends as easily. Of an island with a hull of breadth b and length l it is
// (l · b³)^¼. With F = 0.64 N, which PrusaSlicer expects of curled edges (65 g), and E = 2,000 MPa,
// a column kColumnSlenderness times as high as thick gives way by 0.66 mm² / t: by more than a road
// where it is 1 mm thick, by a fifth of one where it is kColumnThicknesses_mm's last.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry.h"         // Box, Point, Ring
#include "core/limits.h"           // kStandingIslandsMax
#include "core/regions/region.h"   // Region
#include "core/slices/foothold.h"  // Foot
#include "core/slices/slice.h"     // Slice
#include "core/units.h"            // Length

namespace core {

inline constexpr double kColumnSlenderness = 8;

// Below each of these a stretch of its own is followed, so that what gets thinner upwards is judged
// by its thin part, too.
inline constexpr std::array<double, 8> kColumnThicknesses_mm{1, 1.5, 2, 3, 4, 6, 8, 10};

struct StandingBody {
  Foot foot;      // without a brim
  Length height;  // of its top; or up to where it is joined with another
};

struct ThinColumn {
  Point at;                 // in the middle of its highest island's box
  Length bottom, top;       // above the bed
  double thickness_mm = 0;  // where it is thickest
  double slenderness = 0;   // height by thickness, or by kRoadBreadth_mm
};

struct StandingReport {
  std::optional<StandingBody> slenderest;  // of all bodies; none of an empty part
  std::int64_t loose_bodies = 0;           // that may come loose, with the brim that there is
  std::optional<StandingBody> loosest;     // of them the one that needs most; then the slenderest
  std::int64_t thin_columns = 0;           // kColumnSlenderness times as high as thick, or more
  std::optional<ThinColumn> thinnest;      // of them the slenderest
  std::int64_t islands_not_followed = 0;   // over kStandingIslandsMax in a layer
};

class Standing {
 public:
  // `brim_mm`: around each island on the bed. REQUIRES: ≥ 0.
  explicit Standing(double brim_mm) : brim_mm_(brim_mm) {}

  // REQUIRES: slices from the bed up; the lowest that is not empty lies on the bed.
  // COSTS: a comparison where the slice equals the one below; else an intersection for every two
  // islands whose boxes overlap. Holds the slice, and the hulls of the first one.
  void add(const Slice& slice);

  // The slices that follow are another object's, which is printed when this one is finished.
  void next_object();

  // Of all slices so far. COSTS: O(bodies).
  [[nodiscard]] StandingReport report() const;

 private:
  // A stretch of a column that stays below one of kColumnThicknesses_mm.
  struct Stretch {
    Length bottom;
    double thickest_mm = 0;  // 0: it is not that thin here
  };
  struct Followed {
    Region region;
    Box box;
    std::array<Stretch, kColumnThicknesses_mm.size()> stretches;
    bool counted = false;             // among the thin columns
    std::optional<std::size_t> body;  // none: it began in the air
  };
  struct Body {
    Ring hull;
    double area_mm2 = 0;
    Length height;
    Length joined_at;         // the height at which it was put together; 0: one island
    std::size_t part_of = 0;  // its own number, or that of a body with which it was joined
  };

  void follow(const Slice& slice);
  [[nodiscard]] std::size_t whole(std::size_t body) const;
  [[nodiscard]] Followed followed(Island island, const Slice& slice);
  void start_body(Followed& island, const Ring& hull);
  void join(Followed& island, std::size_t body);
  void judge_columns(Followed& island, Length top);
  static void judge(const Body& body, double brim_mm, StandingReport& report);

  double brim_mm_;
  Region last_;
  std::vector<Followed> islands_;  // of the last slice
  std::vector<Body> bodies_;       // as many as islands on the bed, at most
  bool on_bed_ = true;             // no slice so far
  StandingReport ended_;           // bodies that were joined, and columns
};

}  // namespace core
