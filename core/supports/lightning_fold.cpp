#include "core/supports/lightning_fold.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry.h"                  // Box
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/regions/region.h"            // Region
#include "core/vector.h"                    // Vector

namespace core {
namespace {

constexpr std::array<Vector, 2> kDirections{Vector{1, 0}, Vector{0, 1}};

constexpr Length kTolerance = Length::from_units(50);

// Where the ends of a branch count as at the wall.
constexpr double kAtWall = 2;

const RowSpan* span_with(LineSpansView spans, double at) {
  for (const RowSpan& span : spans) {
    if (span.from <= at && at <= span.to) return &span;
  }
  return nullptr;
}

bool touches(LineSpansView spans, const RowSpan& other) {
  return std::any_of(spans.begin(), spans.end(), [&](const RowSpan& span) {
    return span.from <= other.to + kAtWall && other.from <= span.to + kAtWall;
  });
}

// What is farther than a step from the edge.
Region deep_part(const Region& loose, double step) {
  const Length depth = Length::from_units(std::llround(step));
  return loose.empty() || depth == Length() ? loose : offset(loose, depth, kTolerance);
}

// The lines at whole multiples of the spacing that pass through the region, and the first of them.
std::pair<RowGrid, std::int64_t> lines_over(const Region& region, Vector direction,
                                            double spacing) {
  RowGrid grid{direction, 0, spacing, 0};
  const Box box = region.box();
  const double a = grid.to_rows(box.min).y, b = grid.to_rows(box.max).y;
  const auto first = static_cast<std::int64_t>(std::ceil(std::min(a, b) / spacing));
  const auto last = static_cast<std::int64_t>(std::floor(std::max(a, b) / spacing));
  grid.first = static_cast<double>(first) * spacing;
  grid.count = last < first ? 0 : static_cast<std::size_t>(last - first + 1);
  return {grid, first};
}

void add_branches(LineSpansView branches, LineSpansView loose, const RowGrid& grid, std::size_t row,
                  Branches& all) {
  for (const RowSpan& branch : branches) {
    if (branch.length() < static_cast<double>(kBranchMin.units())) continue;
    const RowSpan* room = span_with(loose, (branch.from + branch.to) / 2);
    if (room == nullptr) continue;
    all.push_back({grid.to_plane(branch.from, row), grid.to_plane(branch.to, row),
                   branch.from - room->from <= kAtWall, room->to - branch.to <= kAtWall});
  }
}

}  // namespace

LightningFold::LightningFold(const Settings& settings)
    : settings_(settings), spacing_(static_cast<double>(branch_spacing(settings).units())) {}

Branches LightningFold::push(const InsideLayer& layer) {
  Branches all;
  const double step =
      above_ ? static_cast<double>(cone_step(*above_, layer, settings_).units()) : 0;
  if (!above_ || above_->loose != layer.loose) inner_ = deep_part(*layer.loose, step);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    Lines lines;
    if (!layer.loose->empty()) {
      const auto [grid, first] = lines_over(*layer.loose, kDirections[i], spacing_);
      const RowCuts loose(grid, *layer.loose), deep(grid, inner_);
      for (std::size_t row = 0; row < grid.count; ++row) {
        const auto number = first + static_cast<std::int64_t>(row);
        const auto above = lines_[i].find(number);
        Line line = next_line(loose[row], deep[row],
                              above == lines_[i].end() ? Line{} : above->second, step);
        add_branches(line.branches, loose[row], grid, row, all);
        lines.emplace(number, std::move(line));
      }
    }
    lines_[i] = std::move(lines);
  }
  above_ = layer;
  return all;
}

LightningFold::Line LightningFold::next_line(LineSpansView loose, LineSpansView deep,
                                             const Line& above, double step) const {
  Line line;
  line.loose.assign(loose.begin(), loose.end());
  LineSpans free = grown_spans(above.free, step);
  for (const RowSpan& begun : subtract_spans(loose, above.loose)) {
    const std::array<RowSpan, 1> span{begun};
    if (!intersect_spans(span, deep).empty() || touches(above.branches, begun)) continue;
    free.push_back(begun);
  }
  line.free = intersect_spans(loose, united_spans(std::move(free)));
  line.free = subtract_spans(line.free, pillars(loose, above, step));
  line.branches = subtract_spans(loose, line.free);
  const LineSpans opened = gaps(loose, line, above, step);
  if (opened.empty()) return line;
  free = line.free;
  free.insert(free.end(), opened.begin(), opened.end());
  line.free = united_spans(std::move(free));
  line.branches = subtract_spans(loose, line.free);
  return line;
}

// What stays of branches that touch no wall and are too short to draw back any further.
LineSpans LightningFold::pillars(LineSpansView loose, const Line& above, double step) const {
  const auto least = static_cast<double>(kPillarLength.units());
  LineSpans kept;
  for (const RowSpan& branch : above.branches) {
    const double middle = (branch.from + branch.to) / 2;
    const RowSpan* room = span_with(loose, middle);
    if (room == nullptr || branch.length() - 2 * step >= least) continue;
    if (branch.from - room->from <= step || room->to - branch.to <= step) continue;
    const double half = std::min(branch.length(), least) / 2;
    kept.push_back({middle - half, middle + half});
  }
  return kept;
}

// Where branches from wall to wall open.
LineSpans LightningFold::gaps(LineSpansView loose, const Line& at, const Line& above,
                              double step) const {
  const double margin = step + static_cast<double>(settings_.road_width.units());
  const double most = kBranchGap * static_cast<double>(settings_.bridge_max.units());
  LineSpans opened;
  for (const RowSpan& branch : at.branches) {
    const RowSpan* room = span_with(loose, (branch.from + branch.to) / 2);
    if (room == nullptr || branch.from > room->from || branch.to < room->to) continue;
    const std::array<RowSpan, 1> whole{branch};
    RowSpan longest;
    for (const RowSpan& both : intersect_spans(whole, above.branches)) {
      if (both.length() > longest.length()) longest = both;
    }
    const double gap = std::min(longest.length() - 2 * margin, most);
    if (gap < 2 * margin) continue;
    const double middle = (longest.from + longest.to) / 2;
    opened.push_back({middle - gap / 2, middle + gap / 2});
  }
  return opened;
}

}  // namespace core
