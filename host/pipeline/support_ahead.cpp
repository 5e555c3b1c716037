#include "host/pipeline/support_ahead.h"

#include <fmt/format.h>

#include <utility>

#include "core/check.h"               // RIND_CHECK
#include "host/system/stage_clock.h"  // CpuTimer

namespace host {

core::Result<TakenSlice> SupportAhead::next(SliceIntake& intake,
                                            const std::function<bool()>& stopped,
                                            WarningBox& warnings) {
  std::optional<core::SupportLayer> support = lookahead_.next();
  while (!support && !ended_) {
    if (stopped()) return TakenSlice{};
    if (core::Status taken = take(intake); !taken.ok()) return taken.error();
    support = lookahead_.next();
    if (const auto cut = lookahead_.take_cut()) {
      warnings.put(fmt::format(
          "supports: what hangs above layer {} was not known when the layers below {:.1f} mm were "
          "laid, so nothing holds it; support_lookahead = {} or more would hold {}, and 0 reads "
          "the whole part first",
          cut->index + settings_.support_lookahead, cut->bottom.mm(), cut->known + 1,
          settings_.supports == core::SupportPlace::kBed ? "what of it is over the bed alone"
                                                         : "it"));
    }
  }
  if (!support) return TakenSlice{};
  RIND_CHECK(!held_.empty());
  Held held = std::move(held_.front());
  held_.pop_front();
  RIND_CHECK(held.taken.slice->index == support->index);
  held.taken.slice->region = *held.region;
  held.taken.support = std::move(support);
  return std::move(held.taken);
}

core::Status SupportAhead::take(SliceIntake& intake) {
  core::Result<TakenSlice> taken = intake.next();
  if (!taken.ok()) return taken.error();
  if (!taken.value().slice) {
    const CpuTimer timer(seconds_);
    ended_ = true;
    lookahead_.end();
    return {};
  }
  Held held{std::move(taken).value(), nullptr};
  core::Region& region = held.taken.slice->region;
  const bool same = !held_.empty() && *held_.back().region == region;
  held.region =
      same ? held_.back().region : std::make_shared<const core::Region>(std::move(region));
  region = {};
  held_.push_back(std::move(held));
  push(held_.back());
  return {};
}

void SupportAhead::push(const Held& held) {
  const CpuTimer timer(seconds_);
  const core::Slice& slice = *held.taken.slice;
  lookahead_.push({slice.index, slice.bottom, slice.height, held.region, slice.marks});
}

}  // namespace host
