#include "core/roads/monotonic_joins.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/regions/polyline.h"     // distance_units
#include "core/roads/boundary_ends.h"  // boundary_ends

namespace core {
namespace {

class MonotonicOrder {
 public:
  MonotonicOrder(const std::vector<ClippedLine>& lines, const std::vector<RowStretch>& stretches,
                 const LineClipper& clipper, Length longest)
      : lines_(lines),
        stretches_(stretches),
        clipper_(clipper),
        longest_(static_cast<double>(longest.units())),
        ends_(boundary_ends(lines, clipper)),
        above_(lines.size()),
        waits_for_(lines.size(), 0) {
    find_touching();
    joined_.partners.assign(ends_.size(), kNotJoined);
  }

  [[nodiscard]] JoinedLines join() {
    for (std::size_t line = 0; line < lines_.size(); ++line) {
      if (waits_for_[line] == 0) free_.push_back(line);
    }
    std::size_t end = 0;  // where the way came out
    while (!free_.empty()) {
      const std::size_t from = joined_.ways.empty() ? 2 * free_.front() : nearest(end);
      joined_.ways.emplace_back();
      end = lay(from);
      while (const std::optional<Step> step = step_from(end)) {
        clipper_.append_way(place_of(lines_, end), place_of(lines_, step->to), step->forwards,
                            joined_.ways.back());
        joined_.partners[end] = step->to;
        joined_.partners[step->to] = end;
        end = lay(step->to);
      }
    }
    return std::move(joined_);
  }

 private:
  struct Step {
    std::size_t to = 0;
    bool forwards = false;
  };

  [[nodiscard]] Point at(std::size_t end) const {
    const std::vector<Point>& points = lines_[end / 2].points;
    return end % 2 == 0 ? points.front() : points.back();
  }

  // Which rows lie beside one another in neighbouring rows.
  void find_touching() {
    std::size_t below = 0;
    for (std::size_t line = 0; line < stretches_.size(); ++line) {
      const RowStretch& upper = stretches_[line];
      const auto before = [&](const RowStretch& lower) {
        return lower.row + 1 < upper.row || (lower.row + 1 == upper.row && lower.to < upper.from);
      };
      // The first of a row looks from the row below's begin on.
      if (line > 0 && stretches_[line - 1].row != upper.row) {
        while (below < line && stretches_[below].row + 1 < upper.row) ++below;
      }
      for (std::size_t lower = below; lower < line; ++lower) {
        if (before(stretches_[lower])) continue;
        if (stretches_[lower].row >= upper.row || stretches_[lower].from > upper.to) break;
        above_[lower].push_back(line);
        ++waits_for_[line];
      }
    }
  }

  // Lays a line from one of its ends; returns the other.
  std::size_t lay(std::size_t from) {
    const std::size_t line = from / 2;
    append_line(lines_[line], from % 2 == 0, joined_.ways.back());
    free_.erase(std::find(free_.begin(), free_.end(), line));
    for (const std::size_t upper : above_[line]) {
      if (--waits_for_[upper] == 0) free_.push_back(upper);
    }
    return from ^ 1U;
  }

  // On along the contour, to a row above that may be laid.
  [[nodiscard]] std::optional<Step> step_from(std::size_t end) const {
    std::optional<Step> best;
    double least = longest_;
    const auto look = [&](std::size_t to, double way, bool forwards) {
      const bool is_above = std::find(above_[end / 2].begin(), above_[end / 2].end(), to / 2) !=
                            above_[end / 2].end();
      if (!is_above || waits_for_[to / 2] != 0 || way > least) return;
      least = way;
      best = {to, forwards};
    };
    look(ends_[end].next, ends_[end].way, true);
    look(ends_[end].before, ends_[ends_[end].before].way, false);
    return best;
  }

  [[nodiscard]] std::size_t nearest(std::size_t end) const {
    std::size_t best = 2 * free_.front();
    for (const std::size_t line : free_) {
      for (const std::size_t from : {2 * line, 2 * line + 1}) {
        if (distance_units(at(end), at(from)) < distance_units(at(end), at(best))) best = from;
      }
    }
    return best;
  }

  const std::vector<ClippedLine>& lines_;
  const std::vector<RowStretch>& stretches_;
  const LineClipper& clipper_;
  double longest_;
  std::vector<BoundaryEnd> ends_;
  std::vector<std::vector<std::size_t>> above_;  // by line: those that wait for it
  std::vector<std::size_t> waits_for_;           // by line: how many lines
  std::vector<std::size_t> free_;                // lines that may be laid
  JoinedLines joined_;
};

}  // namespace

JoinedLines join_monotonic(const std::vector<ClippedLine>& lines,
                           const std::vector<RowStretch>& stretches, const LineClipper& clipper,
                           Length longest) {
  return MonotonicOrder(lines, stretches, clipper, longest).join();
}

}  // namespace core
