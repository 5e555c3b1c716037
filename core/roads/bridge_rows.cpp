#include "core/roads/bridge_rows.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "core/booleans/boolean.h"      // clean, subtract
#include "core/regions/segment_grid.h"  // SegmentGrid

namespace core {
namespace {

using Spans = std::vector<RowSpan>;
using SpansHere = std::span<const RowSpan>;  // of one row

// A join is at most this many row distances long.
constexpr double kJoinMaxDistances = 3;

// What rounding may take from an anchor, in units.
constexpr double kSlack = 20;

const RowSpan* span_at(SpansHere spans, double along) {
  for (const RowSpan& span : spans) {
    if (span.from - kSlack <= along && along <= span.to + kSlack) return &span;
  }
  return nullptr;
}

// What of `way` none of the spans holds.
Spans unheld_in(const RowSpan& way, SpansHere held) {
  Spans gaps;
  double from = way.from;
  for (const RowSpan& span : held) {
    if (span.to <= from) continue;
    if (span.from >= way.to) break;
    if (span.from > from + kSlack) gaps.push_back({from, span.from});
    from = std::max(from, span.to);
  }
  if (from + kSlack < way.to) gaps.push_back({from, way.to});
  return gaps;
}

// One row's stretch inside the area, and what it hangs on.
class RowAnchors {
 public:
  RowAnchors(SpansHere room, SpansHere held, SpansHere holes, double anchor)
      : room_(room), held_(held), holes_(holes), anchor_(anchor) {}

  struct Anchored {
    std::optional<RowSpan> way;  // of the row, as far as it is held on two sides
    Spans spans;                 // of it, in the air
    Spans cut;                   // of the stretch that was asked for
    double cut_mm = 0;           // of them, in the air
  };

  [[nodiscard]] Anchored anchored(RowSpan way) const {
    Anchored result;
    Spans spans = spans_of(way);
    if (spans.empty()) {
      result.way = way;
      return result;
    }
    const RowSpan wanted = way;
    const bool low = anchor(spans.front().from, -1, way.from);
    const bool high = anchor(spans.back().to, 1, way.to);
    if (!low) cut_front(wanted, spans, way, result);
    if (!high && !spans.empty()) cut_back(wanted, spans, way, result);
    if (spans.empty()) return result;
    result.way = way;
    result.spans = std::move(spans);
    return result;
  }

 private:
  // Stretches in the air. A rib too thin for an anchor holds nothing.
  [[nodiscard]] Spans spans_of(const RowSpan& way) const {
    Spans spans;
    for (const RowSpan& gap : unheld_in(way, held_)) {
      const bool thin_rib = !spans.empty() && gap.from - spans.back().to < anchor_ - kSlack;
      if (thin_rib) {
        spans.back().to = gap.to;
      } else {
        spans.push_back(gap);
      }
    }
    return spans;
  }

  // Whether the row is held where its span ends; then its own end moves as far as the anchor needs
  // and the room allows. `side`: −1 at the row's start, 1 at its end.
  [[nodiscard]] bool anchor(double span_end, double side, double& way_end) const {
    const RowSpan* room = span_at(room_, way_end);
    const double bound = room == nullptr ? way_end : side < 0 ? room->from : room->to;
    const RowSpan* holder = nullptr;
    double nearest = 0;
    for (const RowSpan& held : held_) {
      const double away = ((side < 0 ? held.to : held.from) - span_end) * side;
      if (away < -kSlack || (holder != nullptr && away >= nearest)) continue;
      holder = &held;
      nearest = away;
    }
    const double near = span_end + side * nearest;
    // Beyond the room lies a perimeter: half a road of it holds the row's end as well.
    const bool holds = holder != nullptr && holder->length() >= anchor_ - kSlack &&
                       (near - bound) * side <= anchor_ / 2;
    if (!holds) return span_at(holes_, way_end) != nullptr;
    const double deep = near + side * anchor_;
    if ((deep - way_end) * side > 0) {
      way_end = side < 0 ? std::max(deep, bound) : std::min(deep, bound);
    }
    return true;
  }

  void cut_front(const RowSpan& wanted, Spans& spans, RowSpan& way, Anchored& result) const {
    result.cut_mm += spans.front().length();
    const bool only = spans.size() == 1;
    const double to = only ? wanted.to : spans[1].from - anchor_;
    result.cut.push_back({wanted.from, to});
    spans.erase(spans.begin());
    way.from = to;
  }

  void cut_back(const RowSpan& wanted, Spans& spans, RowSpan& way, Anchored& result) const {
    result.cut_mm += spans.back().length();
    const bool only = spans.size() == 1;
    const double from = only ? way.from : spans[spans.size() - 2].to + anchor_;
    result.cut.push_back({from, wanted.to});
    spans.pop_back();
    way.to = from;
  }

  SpansHere room_;
  SpansHere held_;
  SpansHere holes_;
  double anchor_;
};

void add_cuts(const Spans& cuts, double spans_mm, std::size_t row, BridgeRows& rows) {
  rows.cut_spans_mm += spans_mm;
  for (const RowSpan& cut : cuts) {
    rows.cut.push_back({row, cut});
    const double mm = cut.length() / kUnitsPerMm;
    if (mm <= rows.longest_cut_mm) continue;
    rows.longest_cut_mm = mm;
    rows.longest_cut_at = rows.grid.to_plane((cut.from + cut.to) / 2, row);
  }
}

void add_spans(const Spans& spans, std::size_t row, BridgeRows& rows) {
  for (const RowSpan& span : spans) {
    const double mm = span.length() / kUnitsPerMm;
    rows.laid_spans_mm += mm;
    rows.laid_squares_mm2 += mm * mm;
    if (mm <= rows.longest_mm) continue;
    rows.longest_mm = mm;
    rows.longest_at = rows.grid.to_plane((span.from + span.to) / 2, row);
  }
}

// A row's end, drawn back by a hair: it may lie on a contour itself.
Point within_row(const RowGrid& grid, const BridgeRow& row, bool at_end) {
  return grid.to_plane(at_end ? row.way.to - kSlack : row.way.from + kSlack, row.row);
}

std::vector<Segment> contours(const BridgeArea& area) {
  std::vector<Segment> all = edges_of(area.held.rings());
  const std::vector<Segment> room = edges_of(area.room.rings());
  all.insert(all.end(), room.begin(), room.end());
  return all;
}

// The row above that can be joined to the end of this one, or the number of rows.
class Joins {
 public:
  Joins(const BridgeRows& rows, const BridgeArea& area)
      : rows_(rows.rows), grid_(rows.grid), contours_(Length::from_mm(1), contours(area)) {}

  [[nodiscard]] std::size_t next(std::size_t at, bool at_end, const std::vector<bool>& used) const {
    const BridgeRow& row = rows_[at];
    const double end = at_end ? row.way.to : row.way.from;
    const double reach = (kJoinMaxDistances - 1) * grid_.distance;
    for (std::size_t i = at + 1; i < rows_.size() && rows_[i].row <= row.row + 1; ++i) {
      const BridgeRow& other = rows_[i];
      if (used[i] || other.row == row.row) continue;
      const bool held = at_end ? row.to_held && other.to_held : row.from_held && other.from_held;
      const double near = at_end ? other.way.to : other.way.from;
      if (!held || std::abs(near - end) > reach) continue;
      const Segment join{within_row(grid_, row, at_end), within_row(grid_, other, at_end)};
      if (!contours_.crosses(join)) return i;
    }
    return rows_.size();
  }

 private:
  const std::vector<BridgeRow>& rows_;
  const RowGrid& grid_;
  SegmentGrid contours_;
};

}  // namespace

Region rings_near(const Region& region, const Box& box) {
  std::vector<Ring> rings;
  for (const Ring& ring : region.rings()) {
    if (box_of(ring).overlaps(box)) rings.push_back(ring);
  }
  return Region::from_clean_rings(std::move(rings));
}

BridgeRows bridge_rows(const BridgeArea& area, Vector direction, Length distance) {
  BridgeRows result;
  result.grid = even_rows_over(area.region, direction, static_cast<double>(distance.units()));
  const RowGrid& grid = result.grid;
  const RowCuts region(grid, area.region), room(grid, area.room);
  const RowCuts held(grid, area.held), holes(grid, area.holes);
  const auto anchor = static_cast<double>(area.anchor.units());
  for (std::size_t row = 0; row < grid.count; ++row) {
    const RowAnchors anchors(room[row], held[row], holes[row], anchor);
    for (const RowSpan& way : region[row]) {
      if (way.length() < anchor / 2) continue;
      RowAnchors::Anchored found = anchors.anchored(way);
      add_cuts(found.cut, found.cut_mm / kUnitsPerMm, row, result);
      if (!found.way) continue;
      result.rows.push_back({row, *found.way, span_at(held[row], found.way->from) != nullptr,
                             span_at(held[row], found.way->to) != nullptr});
      add_spans(found.spans, row, result);
    }
  }
  return result;
}

Region covered_by(const BridgeRows& rows, const BridgeArea& area) {
  if (rows.cut.empty()) return area.region;
  std::vector<Ring> strips;
  strips.reserve(rows.cut.size());
  for (const BridgeRow& cut : rows.cut) {
    RowGrid edge = rows.grid;
    edge.first -= edge.distance / 2;  // its row n is the lower edge of row n's strip
    const auto at = [&](double along, std::size_t row) { return edge.to_plane(along, row); };
    strips.push_back({at(cut.way.from, cut.row), at(cut.way.to, cut.row),
                      at(cut.way.to, cut.row + 1), at(cut.way.from, cut.row + 1)});
  }
  return subtract(area.region, clean(strips, FillRule::kNonZero));
}

std::vector<std::vector<Point>> joined(const BridgeRows& rows, const BridgeArea& area) {
  const Joins joins(rows, area);
  std::vector<bool> used(rows.rows.size());
  std::vector<std::vector<Point>> lines;
  for (std::size_t first = 0; first < rows.rows.size(); ++first) {
    if (used[first]) continue;
    std::vector<Point>& line = lines.emplace_back();
    bool forward = true;
    for (std::size_t at = first; at < rows.rows.size(); forward = !forward) {
      used[at] = true;
      const BridgeRow& row = rows.rows[at];
      line.push_back(rows.grid.to_plane(forward ? row.way.from : row.way.to, row.row));
      line.push_back(rows.grid.to_plane(forward ? row.way.to : row.way.from, row.row));
      at = joins.next(at, forward, used);
    }
  }
  return lines;
}

}  // namespace core
