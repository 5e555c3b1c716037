// Results and costs of a run, for --stats. Plain values; none grows with the number of layers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/roads/road.h"            // RoadKind
#include "core/slices/slice.h"          // Slice
#include "core/slices/standing.h"       // StandingReport
#include "core/units.h"                 // LayerIndex, Length
#include "core/walls/split_layer.h"     // SplitLayer
#include "host/pipeline/hanging_log.h"  // HangingLog
#include "host/pipeline/layer_pace.h"   // LayerPace
#include "host/pipeline/layer_times.h"  // LayerTimes
#include "host/pipeline/layer_watch.h"  // SlowLayers
#include "host/pipeline/stage_meter.h"  // StageCounts
#include "host/system/stage_clock.h"    // StageClock

namespace host {

// As in the statistics file: "outer_perimeter".
[[nodiscard]] std::string road_kind_name(core::RoadKind kind);

// Millimetres of filament by RoadKind.
using FilamentUse = std::array<double, core::kRoadKindCount>;
[[nodiscard]] double total_mm(const FilamentUse& filament);

// Mended defects of the mesh: how many, and at which heights (the first kDefectHeightsMax).
class DefectLog {
 public:
  void add(const core::Slice& slice);

  [[nodiscard]] std::int64_t layers() const { return layers_; }
  [[nodiscard]] std::int64_t closed_chains() const { return closed_chains_; }
  [[nodiscard]] std::int64_t wide_chains() const { return wide_chains_; }
  [[nodiscard]] std::int64_t dropped_chains() const { return dropped_chains_; }
  [[nodiscard]] std::int64_t flipped_facets() const { return flipped_facets_; }
  [[nodiscard]] std::int64_t doubled_facets() const { return doubled_facets_; }
  [[nodiscard]] std::int64_t turned_contours() const { return turned_contours_; }
  [[nodiscard]] core::Length widest_gap() const { return widest_gap_; }
  [[nodiscard]] const std::vector<core::Length>& heights() const { return heights_; }

  // "3 layers mended (2 gaps closed, widest 0.1 mm; …) at 0.3, 0.5, 0.7 mm"; empty: no defect.
  [[nodiscard]] std::string summary() const;

 private:
  std::int64_t layers_ = 0;
  std::int64_t closed_chains_ = 0;
  std::int64_t wide_chains_ = 0;
  std::int64_t dropped_chains_ = 0;
  std::int64_t flipped_facets_ = 0;
  std::int64_t doubled_facets_ = 0;
  std::int64_t turned_contours_ = 0;
  // The first turned contour: a corner on the bed, and its layer's top.
  core::Point turned_at_;
  core::Length turned_height_;
  core::Length widest_gap_;
  std::vector<core::Length> heights_;
};

// Layers whose results were reused, because the layer equals one before.
struct ReuseCounts {
  std::int64_t offsets = 0;
  std::int64_t splits = 0;
  std::int64_t roads = 0;
};

// Allocations by stage. The first kWarmUpLayers are left out: they fill reusable buffers.
class AllocationLog {
 public:
  // REQUIRES: layers are added in order, from 0.
  void add(std::int64_t layer, const StageCounts& counts);

  // Mean of a layer; 0 before there is any.
  [[nodiscard]] double per_layer(Stage stage) const;

 private:
  std::int64_t layers_ = 0;
  StageCounts counts_{};
};

struct Retries {
  std::int64_t mountains = 0;  // Voronoi diagrams that failed their check
  std::int64_t booleans = 0;   // operands that crossed themselves (core/booleans/boolean.h)
};

// Intersections and subtractions.
struct RegionOperations {
  std::int64_t count = 0;
  int worst = 0;  // most in one layer
};

// The most in memory at once.
struct HeldCounts {
  std::int64_t layers = 0;
  std::int64_t regions = 0;    // partial intersections of the window
  std::int64_t triangles = 0;  // crossing one plane
};

struct Volumes {
  double solid_mm3 = 0;               // of the wall
  double loose_mm3 = 0;               // of the inside
  double regularised_mm3 = 0;         // moved from loose to solid to be printable (regularise.h)
  double filament_density_g_mm3 = 0;  // 0: not known
};

// Of the spool: roads, and what users' lines push out.
struct NeededFilament {
  double mm = 0;
  std::optional<double> to_change_mm;  // up to the first M600; nothing: there is none
};

// Filled by the geometry's thread.
struct GeometryStatistics {
  StageClock clock;
  std::int64_t layers = 0;
  std::int64_t roads = 0;
  std::int64_t arcs = 0;
  HeldCounts peak_held;
  std::int64_t spilled_bytes = 0;  // to temporary files: for sorting, and of slices for supports
  std::int64_t bad_layers = 0;     // bad_layers.h
  SlowLayers slow_layers;          // layer_watch.h
  Retries retries;
  RegionOperations region_operations;  // of the window
  ReuseCounts reused;
  LayerTimes layer_times;     // processor time
  LayerPace pace;             // beside printing time
  AllocationLog allocations;  // only in the program: tests have no hook that counts
  Volumes volumes;
  FilamentUse filament_mm{};
  NeededFilament needed;
  double time_s = 0;  // estimated, heating left out
  bool ended = true;  // false: abandoned in the middle of a layer; no other value here is known
  DefectLog defects;
  HangingLog hanging;
  std::optional<core::StandingReport> standing;  // only of `rind plan`
  // When the first road was written to the file. LinkStatistics has those of a print.
  std::optional<double> first_road_s;      // since the program started
  std::optional<double> first_road_cpu_s;  // of the whole program
  std::optional<double> ended_cpu_s;       // the same, when the last layer was done

  void add_volume(const core::SplitLayer& layer, double moved_mm3);
  // Of a part that has ended: the most that its window held, what it did, and what was reused.
  void add_window(std::int64_t layers_held, std::int64_t regions_held,
                  const RegionOperations& operations);
  void add_reused(const ReuseCounts& more);
};

// Filled by the link's thread.
struct LinkStatistics {
  StageClock clock;
  std::optional<double> first_command_s;  // since the program started, until its ok
  std::optional<double> first_road_s;
  std::optional<double> first_road_cpu_s;  // of the whole program
  std::optional<std::int64_t> slices_cut_at_first_road;
  std::int64_t commands = 0;
  std::int64_t stalls = 0;
  std::int64_t resends = 0;
  double resend_ratio = 0;      // of all lines
  double planner_low_s = 0;     // the planner was less than half full for lack of lines
  std::int64_t slowdowns = 0;   // the feed was lowered because geometry fell behind
  std::int64_t parks = 0;       // the nozzle left the part for the same reason
  std::int64_t recoveries = 0;  // resumed after a lost port or a reset
  int feed_percent = 100;       // that geometry can follow
};

// Peak of this program's resident memory so far.
[[nodiscard]] std::int64_t peak_rss_bytes();

// The statistics as JSON text. `link` is null if nothing was sent.
[[nodiscard]] std::string statistics_json(const GeometryStatistics& geometry,
                                          const LinkStatistics* link);

}  // namespace host
