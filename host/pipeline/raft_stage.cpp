#include "host/pipeline/raft_stage.h"

#include <algorithm>

#include "core/raft_heights.h"  // raft_lift

namespace host {

RaftStage::RaftStage(const core::Settings& settings, const std::optional<Checkpoint>& start)
    : settings_(settings), lift_(core::raft_lift(settings)), start_in_part_(start) {
  if (!start_in_part_) return;
  first_ = std::min(start_in_part_->layer, layers());
  start_in_part_->layer -= first_;
  start_in_part_->bottom = std::max(start_in_part_->bottom - lift_, core::Length());
}

core::Result<core::Raft> RaftStage::under(const core::Slice& slice, const std::string& part) const {
  if (slice.region.empty()) {
    return core::Error{core::ErrorCode::kBadPart,
                       part +
                           ", layer 1: it is empty, so that no raft can be laid under it; set "
                           "raft_layers=0, or let the part begin on the bed"};
  }
  return core::Raft(slice.region, settings_);
}

core::Slice RaftStage::lifted(core::Slice slice) const {
  slice.index += layers();
  slice.bottom += lift_;
  return slice;
}

}  // namespace host
