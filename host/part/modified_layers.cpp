#include "host/part/modified_layers.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "core/limits.h"               // kCoordinateMax
#include "core/slices/plane_sweep.h"   // PlaneSweep
#include "core/slices/slice.h"         // ChangedAreas
#include "host/part/bed_placing.h"     // mm_text, shifted
#include "host/part/mesh_sorter.h"     // MeshSorter
#include "host/part/mesh_survey.h"     // can_be_cut
#include "host/part/modifier_words.h"  // read_modifier
#include "host/part/part_transform.h"  // PartTransform
#include "host/system/limits.h"        // kSortBytesMin
#include "host/system/stage_clock.h"   // CpuTimer

namespace host {
namespace {

using core::Result;
using core::Slice;
using core::Status;
using core::Triangle;

// A body from the file's order to regions.
class SweptBody {
 public:
  SweptBody(ModifierBody body, const core::AreaChange& change, std::size_t sort_bytes)
      : body_(std::move(body)), change_(change), sorter_({sort_bytes, ""}) {}

  [[nodiscard]] Status start(const PartPlacing& placing, const core::Settings& settings,
                             const std::string& file) {
    const PartTransform transform(settings);
    while (true) {
      const Result<std::optional<Triangle>> next = body_.facets.next();
      if (!next.ok()) return next.error();
      if (!next.value()) break;
      const Result<Triangle> made = transform.of(*next.value());
      if (!made.ok()) return refused(file, made.error().message);
      if (!can_be_cut(made.value())) continue;
      for (const core::Vertex& corner : made.value().corners) {
        const std::int64_t x = corner.x + placing.shift.x, y = corner.y + placing.shift.y;
        if (std::max(std::abs(x), std::abs(y)) <= core::kCoordinateMax) continue;
        return refused(file, "it reaches farther than " + mm_text(core::kCoordinateMax) +
                                 " mm from the bed's corner; make it smaller");
      }
      Status added = sorter_.add(shifted(made.value(), placing.shift));
      if (!added.ok()) return added;
    }
    // Facets that are turned over are no reason to doubt the part.
    sweep_.emplace(
        core::PlaneSweep::Options{placing.heights, std::nullopt, settings.simplify_tolerance,
                                  settings.chain_gap_max, core::Box()},
        [this] { return sorter_.next(); });
    return sorter_.finish();
  }

  // Adds what it covers of the next layer.
  [[nodiscard]] Status next(core::ChangedAreas& areas) {
    if (ended_) return {};
    Result<std::optional<Slice>> slice = sweep_->next();
    if (!slice.ok()) return slice.error();
    ended_ = !slice.value();
    if (ended_ || slice.value()->region.empty()) return {};
    areas.push_back({change_, std::move(slice.value()->region)});
    return {};
  }

  [[nodiscard]] std::int64_t spilled_bytes() const { return sorter_.spilled_bytes(); }

 private:
  [[nodiscard]] core::Error refused(const std::string& file, const std::string& cause) const {
    return {core::ErrorCode::kOutOfBounds, file + ": " + body_.name + ": " + cause};
  }

  ModifierBody body_;
  core::AreaChange change_;
  MeshSorter sorter_;
  std::optional<core::PlaneSweep> sweep_;
  bool ended_ = false;
};

class ModifiedLayers : public LayerSource {
 public:
  ModifiedLayers(std::unique_ptr<LayerSource> part, std::vector<std::unique_ptr<SweptBody>> bodies)
      : part_(std::move(part)), bodies_(std::move(bodies)) {}

  [[nodiscard]] Status start(const PartPlacing& placing, const core::Settings& settings,
                             const std::string& file) {
    const CpuTimer timer(seconds_);
    for (const auto& body : bodies_) {
      if (Status started = body->start(placing, settings, file); !started.ok()) return started;
    }
    return {};
  }

  [[nodiscard]] Result<std::optional<Slice>> next() override {
    Result<std::optional<Slice>> slice = part_->next();
    if (!slice.ok() || !slice.value()) return slice;
    const CpuTimer timer(seconds_);
    core::ChangedAreas areas;
    for (const auto& body : bodies_) {
      if (Status read = body->next(areas); !read.ok()) return read.error();
    }
    if (areas.empty()) return slice;
    slice.value()->areas = std::make_shared<const core::ChangedAreas>(std::move(areas));
    return slice;
  }

  void add_to(PartCounters& counters) const {
    counters.slice_cpu_s += seconds_;
    for (const auto& body : bodies_) counters.spilled_bytes += body->spilled_bytes();
  }

 private:
  std::unique_ptr<LayerSource> part_;
  std::vector<std::unique_ptr<SweptBody>> bodies_;
  double seconds_ = 0;  // processor time, besides the part's
};

}  // namespace

Result<OpenedPart> with_modifiers(OpenedPart part, std::vector<ModifierBody> bodies,
                                  const core::Settings& settings, std::size_t sort_bytes,
                                  const std::string& name) {
  std::vector<std::unique_ptr<SweptBody>> swept;
  const std::size_t share =
      std::max(kSortBytesMin, sort_bytes / std::max<std::size_t>(1, bodies.size()));
  std::vector<ModifierWords> all;
  for (const ModifierBody& body : bodies) {
    ModifierWords words = read_modifier(body.settings, settings);
    if (!words.used.empty()) part.modifiers.push_back(body.name + ": " + words.used);
    if (!words.unused.empty()) {
      part.modifiers_unused.push_back(
          name + ": " + body.name + ": not used: " + words.unused +
          "; within a part, the inside's density and pattern, perimeters, speeds and flows can "
          "differ");
    }
    all.push_back(std::move(words));
  }
  leave_out_own(settings, all);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (all[i].changes_nothing()) continue;
    swept.push_back(std::make_unique<SweptBody>(std::move(bodies[i]), all[i].change, share));
  }
  if (swept.empty()) return part;
  auto layers = std::make_unique<ModifiedLayers>(std::move(part.layers), std::move(swept));
  ModifiedLayers* source = layers.get();
  part.layers = std::move(layers);
  part.counters = [own = std::move(part.counters), source] {
    PartCounters counters = own();
    source->add_to(counters);
    return counters;
  };
  if (!part.read_rest) {
    Status started = source->start(part.placing(), settings, name);
    if (!started.ok()) return started.error();
    return part;
  }
  part.read_rest = [read = std::move(part.read_rest), placing = part.placing, settings, name,
                    source]() -> Result<PartSummary> {
    Result<PartSummary> summary = read();
    if (!summary.ok()) return summary;
    Status started = source->start(placing(), settings, name);
    return started.ok() ? std::move(summary) : started.error();
  };
  return part;
}

}  // namespace host
