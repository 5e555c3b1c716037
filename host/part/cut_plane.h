// Cuts a part in two at a height, and keeps one piece.
//
//     ───────╲
//      upper  ╲      it stands on its cut face: planes are counted from there
//     ─ ─ ─ ─ ─ ─    cut: so far above the part's lowest point, after all that part_transform.h
//      lower    │    does to it (with shrinkage, so far when the print is cold)
//     ──────────┘
//
// Facets that reach over the plane are swept whole: the sweep's planes lie on the piece's side. So
// nothing is rounded, no cut face has to be made, and a closed surface is still known as closed.
// Only what asks for the piece's extent sees facets clipped.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"             // Triangle
#include "core/result.h"               // Result
#include "core/settings.h"             // Settings
#include "host/formats/mesh_extent.h"  // MeshExtent

namespace host {

class CutPlane {
 public:
  // REQUIRES: `upper` is the piece that is kept
  CutPlane(std::int64_t z, bool upper) : z_(z), upper_(upper) {}

  // Where the settings cut a part of this extent; nullopt if they don't. Errors start with `name`:
  // a height that is not within the part; both pieces are asked for.
  // REQUIRES: check_part_transform() is fine
  [[nodiscard]] static core::Result<std::optional<CutPlane>> of(const core::Settings& settings,
                                                                std::int64_t lowest_z,
                                                                std::int64_t highest_z,
                                                                const std::string& name);

  [[nodiscard]] std::int64_t z() const { return z_; }
  [[nodiscard]] bool upper() const { return upper_; }

  // Whether some of it belongs to the piece. What only touches the plane does not.
  [[nodiscard]] bool keeps(const core::Triangle& triangle) const {
    return upper_ ? triangle.highest_z() > z_ : triangle.lowest_z() < z_;
  }

  // What of it belongs to the piece, to the nearest unit: no triangle, one, or two.
  [[nodiscard]] std::vector<core::Triangle> clipped(const core::Triangle& triangle) const;

  // The face that the cut makes is within this one.
  [[nodiscard]] core::Triangle face(const core::Box& box) const;

 private:
  std::int64_t z_;
  bool upper_;
};

// An error if both pieces are asked for. REQUIRES: check_part_transform() is fine
[[nodiscard]] core::Status check_one_piece(const core::Settings& settings, const std::string& name);

// Whether the settings cut parts. REQUIRES: check_part_transform() is fine
[[nodiscard]] bool is_cut(const core::Settings& settings);

}  // namespace host
