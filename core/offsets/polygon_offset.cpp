#include "core/offsets/polygon_offset.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/check.h"                     // RIND_CHECK
#include "core/limits.h"                    // kDepthTriesMax
#include "core/offsets/offset_input.h"      // OffsetInput
#include "core/offsets/offset_runs.h"       // find_runs
#include "core/offsets/offset_search.h"     // OffsetSearch
#include "core/offsets/offset_trim.h"       // OffsetTrim
#include "core/offsets/voronoi_mountain.h"  // VoronoiMountain

namespace core {
namespace {

// Units. Large against rounding, about 1e-9. Small against a unit even where it counts most: two
// arcs of radius d that just touch part by sqrt(2 · d · kNudge), 1.3 units for d = 1.35 mm.
constexpr double kNudge = 6e-5;

double depth_of(Length depth) { return std::abs(static_cast<double>(depth.units())); }
double nudged(double depth, int attempt) { return depth + kNudge * (1 + 1.37 * attempt); }

void copy_contours(const Region& region, OffsetContours& out) {
  for (const Ring& ring : region.rings()) {
    out.emplace_back();
    for (const Point p : ring) out.back().push_back({p, OffsetPiece::Kind::kLine, {}});
  }
}

// No point of the region is farther from its contours than half the box's shorter side.
bool deeper_than_any_point(const Box& box, std::int64_t depth) {
  return box.empty() || 2 * depth >= std::min(std::int64_t{box.max.x} - box.min.x,
                                              std::int64_t{box.max.y} - box.min.y);
}

}  // namespace

struct PolygonOffsetter::Scratch {
  OffsetInput contours;
  OffsetSearch search;
  OffsetTrim trim;
  std::vector<std::uint8_t> taken;  // per piece: it continues another
  OffsetContour line;               // the contour that is being written
  OffsetContours spare;             // the memory of contours that were given back
  std::vector<std::size_t> asked;   // depths of this side
  std::vector<double> cut_depths;   // the same, nudged, in ascending order
  std::int64_t retries = 0;
  std::int64_t fallbacks = 0;

  void take_back(OffsetContours& old);
  void cut_side(const Region& region, const Box& box, std::span<const Length> depths,
                std::span<OffsetContours> out, bool outwards);
  void prepare(double deepest);
  void cut(std::span<const double> at_depths);
  bool link(std::size_t at);
  void write(std::size_t at, double depth, bool outwards, OffsetContours& out);
  OffsetPiece piece_at(const TrimmedPiece& piece, double depth, bool outwards) const;
};

PolygonOffsetter::PolygonOffsetter() : scratch_(std::make_unique<Scratch>()) {}
PolygonOffsetter::~PolygonOffsetter() = default;
PolygonOffsetter::PolygonOffsetter(PolygonOffsetter&&) noexcept = default;
PolygonOffsetter& PolygonOffsetter::operator=(PolygonOffsetter&&) noexcept = default;

std::int64_t PolygonOffsetter::retries() const { return scratch_->retries; }
std::int64_t PolygonOffsetter::fallbacks() const { return scratch_->fallbacks; }

OffsetContours PolygonOffsetter::offset(const Region& region, Length depth) {
  OffsetContours out;
  offset(region, std::span(&depth, 1), std::span(&out, 1));
  return out;
}

void PolygonOffsetter::offset(const Region& region, std::span<const Length> depths,
                              std::span<OffsetContours> out) {
  RIND_CHECK(depths.size() == out.size());
  for (std::size_t i = 0; i < depths.size(); ++i) {
    scratch_->take_back(out[i]);
    if (depths[i] == Length()) copy_contours(region, out[i]);
  }
  const Box box = region.box();
  scratch_->cut_side(region, box, depths, out, false);
  scratch_->cut_side(region, box, depths, out, true);
}

void PolygonOffsetter::Scratch::take_back(OffsetContours& old) {
  for (OffsetContour& contour : old) {
    contour.clear();
    spare.push_back(std::move(contour));
  }
  old.clear();
}

void PolygonOffsetter::Scratch::cut_side(const Region& region, const Box& box,
                                         std::span<const Length> depths,
                                         std::span<OffsetContours> out, bool outwards) {
  asked.clear();
  std::int64_t deepest = 0;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const std::int64_t depth = outwards ? -depths[i].units() : depths[i].units();
    if (depth <= 0 || (!outwards && deeper_than_any_point(box, depth))) continue;
    asked.push_back(i);
    deepest = std::max(deepest, depth);
  }
  if (asked.empty() || region.empty()) return;
  contours.load(region, box, outwards);
  prepare(static_cast<double>(deepest) + 1);
  std::sort(asked.begin(), asked.end(), [&](std::size_t i, std::size_t k) {
    const std::int64_t a = std::abs(depths[i].units()), b = std::abs(depths[k].units());
    return a != b ? a < b : i < k;
  });
  cut_depths.clear();
  for (const std::size_t i : asked) cut_depths.push_back(nudged(depth_of(depths[i]), 0));
  cut(cut_depths);
  bool recut = false;  // the pieces are no longer those of all depths
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const std::size_t i = asked[k];
    if (recut) cut(std::span(cut_depths).subspan(k, 1));
    std::size_t at = recut ? 0 : k;
    double depth = cut_depths[k];
    int attempt = 0;
    while (!link(at) && ++attempt < kDepthTriesMax) {
      depth = nudged(depth_of(depths[i]), attempt);
      cut(std::span(&depth, 1));
      at = 0;
      recut = true;
    }
    retries += attempt;
    if (attempt < kDepthTriesMax) {
      write(at, depth, outwards, out[i]);
    } else {
      ++fallbacks;
      out[i] = VoronoiMountain(region).offset(depths[i]);
    }
  }
}

void PolygonOffsetter::Scratch::prepare(double deepest) {
  find_runs(contours, deepest);
  search.prepare(contours, deepest);
}

void PolygonOffsetter::Scratch::cut(std::span<const double> at_depths) {
  if (trim.trim(contours, search, at_depths)) return;
  contours.mend_touching();
  prepare(search.deepest());
  RIND_CHECK(trim.trim(contours, search, at_depths));
}

// A piece of element a that ends at site b is followed by the piece of element b that starts at a.
// True when that is a permutation of the pieces.
bool PolygonOffsetter::Scratch::link(std::size_t at) {
  const std::span<TrimmedPiece> pieces = trim.pieces(at);
  taken.assign(pieces.size(), 0);
  for (TrimmedPiece& piece : pieces) {
    auto i = static_cast<std::size_t>(trim.first(at, piece.to_site));
    const auto last = static_cast<std::size_t>(trim.first(at, piece.to_site + 1));
    while (i < last && (pieces[i].from_site != piece.element || taken[i])) ++i;
    if (i == last) return false;
    taken[i] = 1;
    piece.next = static_cast<std::int32_t>(i);
  }
  return true;
}

void PolygonOffsetter::Scratch::write(std::size_t at, double depth, bool outwards,
                                      OffsetContours& out) {
  const std::span<const TrimmedPiece> pieces = trim.pieces(at);
  if (line.size() < pieces.size()) line.resize(pieces.size());
  for (std::size_t first = 0; first < pieces.size(); ++first) {
    if (!taken[first]) continue;
    std::size_t count = 0, i = first;
    do {
      taken[i] = 0;
      const OffsetPiece piece = piece_at(pieces[i], depth, outwards);
      // A piece shorter than the grid vanishes; what follows it starts where it started.
      if (count > 0 && line[count - 1].from == piece.from) --count;
      line[count++] = piece;
      i = static_cast<std::size_t>(pieces[i].next);
    } while (i != first);
    if (count > 1 && line[count - 1].from == line[0].from) --count;
    constexpr auto kLine = OffsetPiece::Kind::kLine;
    if (count < 2 || (count == 2 && line[0].kind == kLine && line[1].kind == kLine)) continue;
    if (spare.empty()) spare.emplace_back();
    out.push_back(std::move(spare.back()));
    spare.pop_back();
    out.back().assign(line.data(), line.data() + count);
  }
}

OffsetPiece PolygonOffsetter::Scratch::piece_at(const TrimmedPiece& piece, double depth,
                                                bool outwards) const {
  const std::int32_t index = piece.element / 2;
  const OffsetEdge& edge = contours.edges()[static_cast<std::size_t>(index)];
  if (piece.element % 2 == 0) {
    const double along = piece.from * edge.inverse_length, up = depth * edge.inverse_length;
    return {contours.to_grid(edge.x + edge.dx * along - edge.dy * up,
                             edge.y + edge.dy * along + edge.dx * up),
            OffsetPiece::Kind::kLine,
            {}};
  }
  const auto kind =
      outwards ? OffsetPiece::Kind::kArcCounterClockwise : OffsetPiece::Kind::kArcClockwise;
  const Point centre = contours.to_grid(edge.x, edge.y);
  if (piece.from_site == 2 * edge.previous) {  // the arc's own start
    const OffsetEdge& before = contours.edges()[static_cast<std::size_t>(edge.previous)];
    const double up = depth * before.inverse_length;
    return {contours.to_grid(edge.x - before.dy * up, edge.y + before.dx * up), kind, centre};
  }
  const OffsetArc arc = contours.arc(index);
  const double t = piece.from, up = depth * (1 - t * t) / (1 + t * t);
  const double right = depth * 2 * t / (1 + t * t);
  return {contours.to_grid(edge.x + arc.middle_x * up + arc.middle_y * right,
                           edge.y + arc.middle_y * up - arc.middle_x * right),
          kind, centre};
}

}  // namespace core
