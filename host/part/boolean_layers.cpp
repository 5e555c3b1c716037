#include "host/part/boolean_layers.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"     // unite, intersect, subtract
#include "core/limits.h"               // kCoordinateMax
#include "core/slices/height_plan.h"   // adaptive_limits, layer_heights
#include "core/slices/plane_sweep.h"   // PlaneSweep
#include "host/part/bed_placing.h"     // shift_to_bed, check_on_bed
#include "host/part/cut_plane.h"       // CutPlane
#include "host/part/edge_ledger.h"     // EdgeLedger
#include "host/part/mesh_sorter.h"     // MeshSorter
#include "host/part/mesh_survey.h"     // is_degenerate, turned_text
#include "host/part/part_heights.h"    // part_heights
#include "host/part/part_transform.h"  // PartTransform
#include "host/system/limits.h"        // kSortBytesMin
#include "host/system/stage_clock.h"   // CpuTimer

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Length;
using core::Region;
using core::Result;
using core::Slice;
using core::Status;
using core::Triangle;
using Kind = ShellNode::Kind;

// One mesh, from its triangles to its slices.
struct Operand {
  explicit Operand(std::size_t sort_bytes) : sorter({sort_bytes, ""}) {}

  MeshSorter sorter;
  MeshExtent extent;
  EdgeLedger edges;
  std::optional<core::PlaneSweep> sweep;
};

bool is_flat(const MeshExtent& extent) {
  return extent.box.empty() || extent.lowest_z >= extent.highest_z;
}

void common(const MeshExtent& other, MeshExtent& into) {
  into.box.min = {std::max(into.box.min.x, other.box.min.x),
                  std::max(into.box.min.y, other.box.min.y)};
  into.box.max = {std::min(into.box.max.x, other.box.max.x),
                  std::min(into.box.max.y, other.box.max.y)};
  if (into.box.min.x > into.box.max.x || into.box.min.y > into.box.max.y) into.box = {};
  into.reach = {};  // what they have in common may reach less far
  into.lowest_z = std::max(into.lowest_z, other.lowest_z);
  into.highest_z = std::min(into.highest_z, other.highest_z);
}

class BooleanLayers : public LayerSource {
 public:
  BooleanLayers(std::unique_ptr<ShellTree> tree, const core::Settings& settings,
                const OpenOptions& options)
      : tree_(std::move(tree)),
        settings_(settings),
        sort_bytes_(std::max(kSortBytesMin, options.sort_bytes / tree_->operands.size())) {
    summary_.format = tree_->format;
  }

  [[nodiscard]] Result<PartSummary> read_rest() {
    for (const std::vector<Shell>& shells : tree_->operands) {
      operands_.push_back(std::make_unique<Operand>(sort_bytes_));
      if (Status read = read_operand(shells, *operands_.back()); !read.ok()) return read.error();
    }
    if (Status placed = place(); !placed.ok()) return placed.error();
    core::PlaneSweep::Options sweep{
        heights_, summary_.layers, settings_.simplify_tolerance, settings_.chain_gap_max, {}};
    summary_.warnings = tree_->warnings;
    for (const auto& operand : operands_) {
      Operand* source = operand.get();
      sweep.unsure.reset();
      if (const auto turned = source->edges.turned()) {
        sweep.unsure = turned->placed ? shifted(turned->box, shift_) : core::Box();
        summary_.warnings.push_back(tree_->name + ": " + turned_text(*turned));
      }
      source->sweep.emplace(sweep, [this, source] { return next_of(*source); });
    }
    return summary_;
  }

  [[nodiscard]] Result<std::optional<Slice>> next() override {
    const double start_s = thread_cpu_seconds(), before_s = counters_.sort_cpu_s;
    Result<std::optional<Slice>> slice = cut();
    counters_.slice_cpu_s += thread_cpu_seconds() - start_s - (counters_.sort_cpu_s - before_s);
    return slice;
  }

  [[nodiscard]] const PartSummary& summary() const { return summary_; }
  [[nodiscard]] const PartCounters& counters() const { return counters_; }
  [[nodiscard]] PartPlacing placing() const { return {shift_, heights_}; }

 private:
  [[nodiscard]] Error refused(ErrorCode code, const std::string& cause) const {
    return {code, tree_->name + ": " + cause};
  }

  [[nodiscard]] Status read_operand(const std::vector<Shell>& shells, Operand& operand) {
    for (const Shell& shell : shells) {
      const std::string cause =
          tree_->store.add_item(shell.key, shell.transform, shell.reversed, shell.role);
      if (!cause.empty()) return refused(ErrorCode::kBadPart, cause);
    }
    while (true) {
      const MeshStore::Next next = tree_->store.next();
      if (!next.error.empty()) return refused(ErrorCode::kOutOfBounds, next.error);
      if (!next.triangle) break;
      const Result<Triangle> larger = transform_.of(*next.triangle);
      if (!larger.ok()) return refused(larger.error().code, larger.error().message);
      const Triangle& triangle = larger.value();
      ++summary_.facets;
      operand.extent.add(triangle);
      if (is_degenerate(triangle)) {
        ++summary_.degenerate;
        continue;
      }
      operand.edges.add(triangle);
      if (limits_) limits_->add(triangle);
      if (triangle.lowest_z() == triangle.highest_z()) continue;
      if (Status added = operand.sorter.add(triangle); !added.ok()) return added;
    }
    const CpuTimer timer(counters_.sort_cpu_s);
    return operand.sorter.finish();
  }

  // Upper bound of the extent, from the operands' boxes.
  [[nodiscard]] MeshExtent extent_of(const ShellNode& node) const {
    if (node.kind == Kind::kOperand) return operands_[node.operand]->extent;
    MeshExtent extent = extent_of(tree_->nodes[node.inputs[0]]);
    if (node.kind == Kind::kDifference) {
      extent.reach = {};
      return extent;
    }
    for (std::size_t i = 1; i < node.inputs.size(); ++i) {
      const MeshExtent other = extent_of(tree_->nodes[node.inputs[i]]);
      if (node.kind == Kind::kIntersection) {
        common(other, extent);
      } else if (!is_flat(other)) {
        extent.box.add(other.box);
        extent.reach.add(other.reach);
        extent.lowest_z = std::min(extent.lowest_z, other.lowest_z);
        extent.highest_z = std::max(extent.highest_z, other.highest_z);
      }
    }
    return extent;
  }

  [[nodiscard]] Error nothing_left() const {
    return refused(ErrorCode::kBadPart,
                   "the booleans leave nothing that has a height; check the part" +
                       std::string(plane_ ? ", and where it is cut" : ""));
  }

  // Makes the operands' extents those of their pieces, if there is a cut.
  [[nodiscard]] Status cut_operands(const MeshExtent& whole) {
    const Result<std::optional<CutPlane>> plane =
        CutPlane::of(settings_, whole.lowest_z, whole.highest_z, tree_->name);
    if (!plane.ok()) return plane.error();
    plane_ = plane.value();
    if (!plane_) return {};
    if (limits_) limits_->add(plane_->face(whole.box));
    const CpuTimer timer(counters_.sort_cpu_s);
    for (const auto& operand : operands_) {
      operand->extent = {};
      while (true) {
        const Result<std::optional<Triangle>> next = operand->sorter.next();
        if (!next.ok()) return next.error();
        if (!next.value()) break;
        if (!plane_->keeps(*next.value())) continue;
        for (const Triangle& part : plane_->clipped(*next.value())) operand->extent.add(part);
      }
      if (Status again = operand->sorter.rewind(); !again.ok()) return again;
    }
    return {};
  }

  // The next facet that the sweep needs.
  [[nodiscard]] Result<std::optional<Triangle>> next_of(Operand& operand) {
    const CpuTimer timer(counters_.sort_cpu_s);
    while (true) {
      Result<std::optional<Triangle>> triangle = operand.sorter.next();
      if (!triangle.ok() || !triangle.value()) return triangle;
      if (plane_ && !plane_->keeps(*triangle.value())) continue;
      return std::optional<Triangle>(shifted(*triangle.value(), shift_));
    }
  }

  [[nodiscard]] Status place() {
    MeshExtent extent = extent_of(tree_->nodes.back());
    if (is_flat(extent)) return nothing_left();
    if (Status cut = cut_operands(extent); !cut.ok()) return cut;
    if (plane_) extent = extent_of(tree_->nodes.back());
    if (is_flat(extent)) return nothing_left();
    summary_.height = Length::from_units(extent.highest_z - extent.lowest_z);
    Result<core::LayerHeights> heights =
        part_heights(settings_, limits_, extent.lowest_z, summary_.height, tree_->name);
    if (!heights.ok()) return heights.error();
    heights_ = std::move(heights).value();
    summarise_heights(heights_, summary_);
    if (summary_.layers == 0) {
      return refused(ErrorCode::kBadPart,
                     "the part is " + mm_text(summary_.height.units()) +
                         " mm high, less than half a layer; check its unit, or lower layer_height");
    }
    shift_ = shift_to_bed(extent, settings_);
    if (Status fits = check_on_bed(extent, shift_, settings_, tree_->name); !fits.ok()) return fits;
    summary_.box = shifted(extent.box, shift_);
    for (const auto& operand : operands_) {
      const core::Box& box = operand->extent.box;
      const std::int64_t farthest = std::max({-(box.min.x + shift_.x), -(box.min.y + shift_.y),
                                              box.max.x + shift_.x, box.max.y + shift_.y});
      if (box.empty() || farthest <= core::kCoordinateMax) continue;
      return refused(ErrorCode::kOutOfBounds, "what is cut off reaches farther than " +
                                                  mm_text(core::kCoordinateMax) +
                                                  " mm from the bed's corner; make it smaller");
    }
    return {};
  }

  [[nodiscard]] Result<std::optional<Slice>> cut() {
    slices_.clear();
    std::int64_t triangles = 0;
    for (const auto& operand : operands_) {
      Result<std::optional<Slice>> slice = operand->sweep->next();
      if (!slice.ok() || !slice.value()) return slice;
      triangles += operand->sweep->peak_triangles_held();
      slices_.push_back(*std::move(slice).value());
    }
    counters_.peak_triangles_held = triangles;
    Slice result = slices_[0];
    for (std::size_t i = 1; i < slices_.size(); ++i) result.defects.add(slices_[i].defects);
    result.region = evaluated(tree_->nodes.back());
    return std::optional<Slice>(std::move(result));
  }

  // Nodes come before the nodes that use them, and nest at most kNestingMax deep.
  [[nodiscard]] Region evaluated(const ShellNode& node) const {
    if (node.kind == Kind::kOperand) return slices_[node.operand].region;
    Region region = evaluated(tree_->nodes[node.inputs[0]]);
    for (std::size_t i = 1; i < node.inputs.size(); ++i) {
      const Region other = evaluated(tree_->nodes[node.inputs[i]]);
      if (node.kind == Kind::kUnion) {
        region = core::unite(region, other);
      } else if (node.kind == Kind::kIntersection) {
        region = core::intersect(region, other);
      } else {
        region = core::subtract(region, other);
      }
    }
    return region;
  }

  std::unique_ptr<ShellTree> tree_;
  core::Settings settings_;
  PartTransform transform_{settings_};
  std::size_t sort_bytes_;
  std::optional<core::HeightLimits> limits_ = adaptive_limits(settings_);  // of all operands
  core::LayerHeights heights_ = layer_heights(settings_);
  PartSummary summary_;
  PartCounters counters_;
  std::vector<std::unique_ptr<Operand>> operands_;
  std::vector<Slice> slices_;  // of one plane
  Shift shift_;
  std::optional<CutPlane> plane_;
};

}  // namespace

Result<OpenedPart> open_booleans(std::unique_ptr<ShellTree> tree, const core::Settings& settings,
                                 const OpenOptions& options) {
  auto layers = std::make_unique<BooleanLayers>(std::move(tree), settings, options);
  OpenedPart part;
  part.summary = layers->summary();
  BooleanLayers* source = layers.get();
  part.read_rest = [source] { return source->read_rest(); };
  part.counters = [source] { return source->counters(); };
  part.placing = [source] { return source->placing(); };
  part.layers = std::move(layers);
  return part;
}

}  // namespace host
