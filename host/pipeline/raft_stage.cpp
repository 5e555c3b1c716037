#include "host/pipeline/raft_stage.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/booleans/boolean.h"  // unite
#include "core/raft_heights.h"      // raft_layer_bottom, raft_lift

namespace host {

RaftStage::RaftStage(const core::Settings& settings, const std::optional<Checkpoint>& start)
    : settings_(settings), lift_(core::raft_lift(settings)), start_in_part_(start) {
  if (!start_in_part_) return;
  first_ = std::min(start_in_part_->layer, layers());
  start_in_part_->layer -= first_;
  start_in_part_->bottom = std::max(start_in_part_->bottom - lift_, core::Length());
}

core::Status RaftStage::lay(const core::SplitLayer& first, const std::string& part,
                            LayerWatch& watch, const Give& give) const {
  if (first_ == layers()) return {};
  const core::Region& slice = first.slice.region;
  const core::Region foot = first.support ? core::unite(slice, *first.support) : slice;
  if (foot.empty()) {
    return core::Error{core::ErrorCode::kBadPart,
                       part +
                           ", layer 1: it is empty, so that no raft can be laid under it; set "
                           "raft_layers=0, or let the part begin on the bed"};
  }
  const core::Raft raft(foot, settings_);
  for (core::LayerIndex index = first_; index < layers(); ++index) {
    // Watched without its motions, which wait for the printer.
    core::RaftLayer laid = [&] {
      double watched_s = 0;
      const LayerWatch::Look look(watch, index, top(index), &foot, watched_s);
      return raft.layer(index);
    }();
    if (core::Status lies = check(laid, part); !lies.ok()) return lies;
    if (core::Status given = give(laid); !given.ok()) return given;
  }
  return {};
}

core::Status RaftStage::check(const core::RaftLayer& layer, const std::string& part) const {
  const auto is_raft = [](const core::Road& road) { return road.kind == core::RoadKind::kRaft; };
  if (std::any_of(layer.roads.begin(), layer.roads.end(), is_raft)) return {};
  return core::Error{
      core::ErrorCode::kBadPart,
      fmt::format(
          "{}: its foot, with raft_expansion = {:g} mm, is too narrow for a road of a raft; "
          "set a larger raft_expansion, or raft_layers=0",
          part, settings_.raft_expansion.mm())};
}

core::Length RaftStage::top(core::LayerIndex index) const {
  return core::raft_layer_bottom(settings_, index) + core::raft_layer_height(settings_, index);
}

core::Slice RaftStage::lifted(core::Slice slice) const {
  slice.index += layers();
  slice.bottom += lift_;
  return slice;
}

}  // namespace host
