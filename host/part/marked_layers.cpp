#include "host/part/marked_layers.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "core/booleans/boolean.h"          // unite
#include "core/booleans/simplified.h"       // simplified
#include "core/limits.h"                    // kCoordinateMax
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/slices/facet_slabs.h"        // FacetSlabs
#include "core/slices/plane_sweep.h"        // PlaneSweep
#include "host/part/cut_plane.h"            // is_cut
#include "host/part/mesh_sorter.h"          // MeshSorter
#include "host/part/mesh_survey.h"          // can_be_cut, is_degenerate
#include "host/part/part_transform.h"       // PartTransform
#include "host/system/limits.h"             // kSortBytesMin
#include "host/system/stage_clock.h"        // CpuTimer

namespace host {
namespace {

using core::Length;
using core::Region;
using core::Result;
using core::Slice;
using core::Status;
using core::Triangle;

constexpr Length kReachTolerance = Length::from_units(100);

// Gaps in enforcing paint that are narrower than so many roads are closed. In blocking paint, what
// people want to be held may lie in them.
constexpr int kGapWidths = 2;

// Kinds of marked facets, each with a sorter: two of bodies, two of painted ones.
constexpr std::size_t kSorters = 4;

core::Error refused(const std::string& name, const std::string& cause) {
  return {core::ErrorCode::kOutOfBounds, name + ": " + cause};
}

Status check_near(const core::Box& box, const Shift& shift, const std::string& name) {
  for (const core::Point corner : {box.min, box.max}) {
    const std::int64_t x = corner.x + shift.x, y = corner.y + shift.y;
    if (std::max(std::abs(x), std::abs(y)) <= core::kCoordinateMax) continue;
    return refused(name, "what marks where supports are to be reaches farther than " +
                             mm_text(core::kCoordinateMax) +
                             " mm from the bed's corner; make it smaller");
  }
  return {};
}

// Of the bodies, enlarged; painted facets are the part's own.
Status check_near(const core::Box& bodies, const core::Settings& settings, const Shift& shift,
                  const std::string& name) {
  const PartTransform by(settings);
  if (by.tilts() || by.longest_mm()) return {};  // told when they are read
  const Result<core::Box> larger = by.of(bodies);
  if (!larger.ok()) return refused(name, larger.error().message);
  return check_near(larger.value(), shift, name);
}

// Before anything is read, where it is known where the part will be.
Status check_so_far(const MarkedFacets& marks, const core::Box& bodies,
                    const core::Settings& settings, const std::string& name) {
  if (marks.printed.box.empty()) return {};
  const PartTransform by(settings);
  if (by.tilts() || by.longest_mm() || is_cut(settings)) return {};
  const Result<core::Box> larger = by.of(marks.printed.box);
  if (!larger.ok()) return {};  // told of the part itself
  MeshExtent printed = marks.printed;
  printed.box = larger.value();
  return check_near(bodies, settings, shift_to_bed(printed, settings), name);
}

// Some marked facets, from the file's order to regions.
class MarkedRegions {
 public:
  explicit MarkedRegions(std::size_t sort_bytes) : sorter_({sort_bytes, ""}) {}

  [[nodiscard]] bool empty() const { return sorter_.size() == 0; }
  [[nodiscard]] std::int64_t spilled_bytes() const { return sorter_.spilled_bytes(); }

  [[nodiscard]] Status add(const Triangle& triangle) { return sorter_.add(triangle); }

  [[nodiscard]] Status start_bodies(const core::LayerHeights& heights,
                                    const core::Settings& settings) {
    sweep_.emplace(core::PlaneSweep::Options{heights, std::nullopt, settings.simplify_tolerance,
                                             settings.chain_gap_max, core::Box()},
                   [this] { return sorter_.next(); });
    return sorter_.finish();
  }

  [[nodiscard]] Status start_painted(const core::LayerHeights& heights, Length reach, Length gap) {
    reach_ = reach;
    half_gap_ = Length::from_units(gap.units() / 2);
    slabs_.emplace(heights, [this] { return sorter_.next(); });
    return sorter_.finish();
  }

  // Of the next layer.
  [[nodiscard]] Result<Region> next() {
    if (slabs_) {
      Result<Region> found = slabs_->next();
      if (!found.ok() || found.value().empty()) return found;
      // Wider by half a gap more, and back.
      const Region wide = core::offset(core::simplified(found.value(), kReachTolerance),
                                       -(reach_ + half_gap_), kReachTolerance);
      if (half_gap_ == Length()) return wide;
      return core::offset(core::simplified(wide, kReachTolerance), half_gap_, kReachTolerance);
    }
    if (ended_) return Region();
    Result<std::optional<Slice>> slice = sweep_->next();
    if (!slice.ok()) return slice.error();
    ended_ = !slice.value();
    return ended_ ? Region() : std::move(slice.value()->region);
  }

 private:
  MeshSorter sorter_;
  std::optional<core::PlaneSweep> sweep_;  // of bodies
  std::optional<core::FacetSlabs> slabs_;  // of painted facets
  Length reach_, half_gap_;
  bool ended_ = false;
};

class MarkedLayers : public LayerSource {
 public:
  MarkedLayers(std::unique_ptr<LayerSource> part, std::function<PartPlacing()> placing,
               std::unique_ptr<MarkedFacets> marks, const core::Settings& settings,
               std::size_t sort_bytes, std::string name)
      : part_(std::move(part)),
        placing_(std::move(placing)),
        marks_(std::move(marks)),
        settings_(settings),
        sort_bytes_(std::max(kSortBytesMin, sort_bytes / kSorters)),
        name_(std::move(name)) {}

  [[nodiscard]] Result<std::optional<Slice>> next() override {
    if (marks_) {
      const std::unique_ptr<MarkedFacets> marks = std::move(marks_);
      if (Status started = start(*marks); !started.ok()) return started.error();
    }
    Result<std::optional<Slice>> slice = part_->next();
    if (!slice.ok() || !slice.value()) return slice;
    const CpuTimer timer(seconds_);
    core::SupportMarks found;
    if (Status read = gather(enforced_, found.enforced); !read.ok()) return read.error();
    if (Status read = gather(blocked_, found.blocked); !read.ok()) return read.error();
    if (found.enforced.empty() && found.blocked.empty()) return slice;
    slice.value()->marks = std::make_shared<const core::SupportMarks>(std::move(found));
    return slice;
  }

  [[nodiscard]] std::int64_t spilled_bytes() const { return spilled_bytes_; }
  // Processor time, besides the part's.
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  using Regions = std::vector<std::unique_ptr<MarkedRegions>>;

  [[nodiscard]] Status start(MarkedFacets& marks) {
    const CpuTimer timer(seconds_);
    const PartPlacing placing = placing_();
    const Length reach = kPaintReach + std::max(magnitude(settings_.contour_compensation),
                                                magnitude(settings_.hole_compensation));
    for (const SupportMark mark : {SupportMark::kEnforcer, SupportMark::kBlocker}) {
      Regions& into = mark == SupportMark::kEnforcer ? enforced_ : blocked_;
      auto bodies = std::make_unique<MarkedRegions>(sort_bytes_);
      if (Status taken = take(marks.bodies(mark), placing.shift, true, *bodies); !taken.ok()) {
        return taken;
      }
      auto painted = std::make_unique<MarkedRegions>(sort_bytes_);
      if (Status taken = take(marks.painted(mark), placing.shift, false, *painted); !taken.ok()) {
        return taken;
      }
      if (!bodies->empty()) {
        Status started = bodies->start_bodies(placing.heights, settings_);
        if (!started.ok()) return started;
        spilled_bytes_ += bodies->spilled_bytes();
        into.push_back(std::move(bodies));
      }
      if (!painted->empty()) {
        const Length gap =
            mark == SupportMark::kEnforcer ? settings_.road_width * kGapWidths : Length();
        Status started = painted->start_painted(placing.heights, reach, gap);
        if (!started.ok()) return started;
        spilled_bytes_ += painted->spilled_bytes();
        into.push_back(std::move(painted));
      }
    }
    return {};
  }

  static Length magnitude(Length length) { return length < Length() ? -length : length; }

  // Sorts those that matter, where the part is.
  [[nodiscard]] Status take(FacetSpool& facets, const Shift& shift, bool bodies,
                            MarkedRegions& into) const {
    const PartTransform transform(settings_);
    while (true) {
      const Result<std::optional<Triangle>> next = facets.next();
      if (!next.ok()) return next.error();
      if (!next.value()) return {};
      const Result<Triangle> larger = transform.of(*next.value());
      if (!larger.ok()) return refused(name_, larger.error().message);
      const Triangle& triangle = larger.value();
      if (bodies ? !can_be_cut(triangle) : is_degenerate(triangle)) continue;
      core::Box box;
      for (const core::Vertex& corner : triangle.corners) box.add(core::Point{corner.x, corner.y});
      if (Status near = check_near(box, shift, name_); !near.ok()) return near;
      if (Status added = into.add(shifted(triangle, shift)); !added.ok()) return added;
    }
  }

  [[nodiscard]] static Status gather(const Regions& regions, Region& into) {
    for (const auto& one : regions) {
      Result<Region> found = one->next();
      if (!found.ok()) return found.error();
      into = into.empty() ? std::move(found).value() : core::unite(into, found.value());
    }
    return {};
  }

  std::unique_ptr<LayerSource> part_;
  std::function<PartPlacing()> placing_;
  std::unique_ptr<MarkedFacets> marks_;  // until the first slice
  core::Settings settings_;
  std::size_t sort_bytes_;
  std::string name_;
  Regions enforced_, blocked_;
  std::int64_t spilled_bytes_ = 0;
  double seconds_ = 0;
};

}  // namespace

Result<OpenedPart> with_marks(OpenedPart part, std::unique_ptr<MarkedFacets> marks,
                              const core::Settings& settings, std::size_t sort_bytes,
                              const std::string& name) {
  part.enforced = marks->enforces();
  if (const core::Box bodies = marks->bodies_extent().box; !bodies.empty()) {
    if (Status near = check_so_far(*marks, bodies, settings, name); !near.ok()) return near.error();
    if (part.read_rest) {
      part.read_rest = [read = std::move(part.read_rest), placing = part.placing, bodies, settings,
                        name]() -> Result<PartSummary> {
        Result<PartSummary> summary = read();
        if (!summary.ok()) return summary;
        Status near = check_near(bodies, settings, placing().shift, name);
        return near.ok() ? std::move(summary) : near.error();
      };
    }
  }
  auto layers = std::make_unique<MarkedLayers>(std::move(part.layers), part.placing,
                                               std::move(marks), settings, sort_bytes, name);
  part.counters = [own = std::move(part.counters), source = layers.get()] {
    PartCounters counters = own();
    counters.spilled_bytes += source->spilled_bytes();
    counters.slice_cpu_s += source->seconds();
    return counters;
  };
  part.layers = std::move(layers);
  return part;
}

}  // namespace host
