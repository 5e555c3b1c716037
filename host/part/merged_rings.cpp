#include "host/part/merged_rings.h"

#include <iterator>
#include <memory>
#include <utility>

#include "host/part/moved_slice.h"  // clipped, moved

namespace host {
namespace {

void append(const core::Region& region, const Shift& shift, std::vector<core::Ring>& rings) {
  std::vector<core::Ring> more = moved(region, shift).rings();
  std::move(more.begin(), more.end(), std::back_inserter(rings));
}

}  // namespace

void MergedRings::add(const core::Slice& part, const core::Box& room,
                      const std::vector<Shift>& places) {
  core::SupportMarks marks;
  if (part.marks) {
    marks = {clipped(part.marks->enforced, room), clipped(part.marks->blocked, room)};
  }
  core::ChangedAreas changes;
  if (part.areas) changes = *part.areas;
  for (core::ChangedArea& area : changes) area.region = clipped(area.region, room);
  for (const Shift& shift : places) {
    append(part.region, shift, slice_);
    append(marks.enforced, shift, enforced_);
    append(marks.blocked, shift, blocked_);
    for (const core::ChangedArea& area : changes) {
      if (!area.region.empty()) areas_.push_back({area.change, moved(area.region, shift)});
    }
  }
}

void MergedRings::put_into(core::Slice& merged) {
  merged.region = core::Region::from_clean_rings(std::move(slice_));
  merged.areas =
      areas_.empty() ? nullptr : std::make_shared<const core::ChangedAreas>(std::move(areas_));
  merged.marks = nullptr;
  if (enforced_.empty() && blocked_.empty()) return;
  merged.marks = std::make_shared<const core::SupportMarks>(
      core::SupportMarks{core::Region::from_clean_rings(std::move(enforced_)),
                         core::Region::from_clean_rings(std::move(blocked_))});
}

}  // namespace host
