#include "host/part/outermost_corners.h"

#include <algorithm>

#include "host/part/bed_placing.h"  // mm_text

namespace host {
namespace {

// The coordinate in that direction.
std::int64_t reach(const core::Vertex& at, Direction direction) {
  switch (direction) {
    case Direction::kLeft:
      return -std::int64_t{at.x};
    case Direction::kRight:
      return at.x;
    case Direction::kFront:
      return -std::int64_t{at.y};
    case Direction::kBack:
      return at.y;
    case Direction::kDown:
      return -at.z;
    case Direction::kUp:
      return at.z;
  }
  return 0;
}

bool backwards(Direction direction) {
  return direction == Direction::kLeft || direction == Direction::kFront ||
         direction == Direction::kDown;
}

}  // namespace

std::string corner_text(const FacetCorner& corner) {
  return "facet " + std::to_string(corner.facet) + " has a corner at " + mm_text(corner.at.x) +
         ", " + mm_text(corner.at.y) + ", " + mm_text(corner.at.z) + " mm";
}

void OutermostCorners::offer(Direction direction, const FacetCorner& corner) {
  Farthest& end = ends_[static_cast<std::size_t>(direction)];
  const std::int64_t far = reach(corner.at, direction);
  const bool full = end.count == end.corners.size();
  const auto last = end.corners.begin() + static_cast<std::ptrdiff_t>(end.count);
  const auto same = [&](const FacetCorner& other) { return other.at == corner.at; };
  if (std::any_of(end.corners.begin(), last, same)) return;
  if (!full) ++end.count;
  std::size_t place = end.count - 1;
  for (; place > 0 && reach(end.corners[place - 1].at, direction) < far; --place) {
    end.corners[place] = end.corners[place - 1];
  }
  end.corners[place] = corner;
  if (end.count == end.corners.size()) {
    limits_[static_cast<std::size_t>(direction)] = reach(end.corners.back().at, direction);
  }
}

std::optional<OutermostCorners::End> OutermostCorners::end(Direction direction) const {
  const Farthest& end = ends_[static_cast<std::size_t>(direction)];
  if (end.count < 2) return std::nullopt;
  End found{end.corners[0], -1, 0};
  for (std::size_t i = 1; i < end.count; ++i) {
    const std::int64_t rest = reach(end.corners[i].at, direction);
    const std::int64_t alone = reach(end.corners[i - 1].at, direction) - rest;
    if (alone > found.alone) found = {end.corners[0], alone, backwards(direction) ? -rest : rest};
  }
  return found;
}

}  // namespace host
