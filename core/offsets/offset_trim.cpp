#include "core/offsets/offset_trim.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

// Ends nearer than this may be one place (offset_span.h); rounding stays below 1e-9 for lengths
// below 10^6 units and grows with them.
double tolerance_of(double length) { return 1e-7 + 1e-12 * length; }

// How far a point may lie beyond a capsule's rim and still be handed to the closed form.
constexpr double kRim = 1e-6;

// Whether a capsule with its ends beside the line, both beyond `at` on the same side, covers the
// point there at height `depth`.
bool covers(EndBeside start, EndBeside end, double at, double depth) {
  const double rim = (depth + kRim) * (depth + kRim);
  const double vx = at - start.along, vy = depth - start.above;
  const double gx = end.along - start.along, gy = end.above - start.above;
  const double foot = vx * gx + vy * gy, length_squared = gx * gx + gy * gy;
  if (foot >= length_squared) return (vx - gx) * (vx - gx) + (vy - gy) * (vy - gy) < rim;
  if (foot <= 0) return vx * vx + vy * vy < rim;
  const double across = vx * gy - vy * gx;
  return across * across < rim * length_squared;
}

}  // namespace

bool OffsetTrim::trim(const OffsetInput& contours, const OffsetSearch& search,
                      std::span<const double> depths) {
  contours_ = &contours;
  edges_ = &contours.edges();
  corners_ = &contours.corners();
  search_ = &search;
  depths_.assign(depths.begin(), depths.end());
  last_coverer_ = -1;
  if (pieces_.size() < depths.size()) pieces_.resize(depths.size());
  for (TrimmedPieces& pieces : pieces_) pieces.clear();
  first_.resize((2 * edges_->size() + 1) * depths.size());
  return contours.wide() ? trim_all<true>() : trim_all<false>();
}

template <bool kWide>
bool OffsetTrim::trim_all() {
  std::int32_t* marked = first_.data();
  const std::span<const TrimmedPieces> pieces = std::span(pieces_).first(depths_.size());
  const auto mark_first = [&] {
    for (const TrimmedPieces& found : pieces) *marked++ = found.count();
  };
  for (std::size_t c = 0; c < search_->chunks().size(); ++c) {
    const OffsetChunk& chunk = search_->chunks()[c];
    const auto near = search_->neighbours(c);
    for (std::int32_t i = chunk.first; i < chunk.last; ++i) {
      mark_first();
      if (near.empty()) {
        add_whole_line(i);
      } else {
        trim_line<kWide>(i, near);
      }
      mark_first();
      if (!corner(i).reflex) continue;
      if (near.empty()) {
        add_whole_arc(i);
      } else if (!trim_arc<kWide>(i, near)) {
        return false;
      }
    }
  }
  mark_first();
  return true;
}

void OffsetTrim::add_whole_line(std::int32_t index) {
  const OffsetSite before = site_before(index), after = site_after(index);
  const double tangent = corner(index).reflex ? 0 : corner(index).half_tangent;
  for (std::size_t at = 0; at < depths_.size(); ++at) {
    pieces_[at].add({depths_[at] * tangent, before, after, 2 * index, -1});
  }
}

template <bool kWide>
void OffsetTrim::trim_line(std::int32_t index, std::span<const std::int32_t> near) {
  const OffsetEdge& e = edge(index);
  const OffsetSite before = site_before(index), after = site_after(index);
  // Within a run the cuts at convex corners are known to hold.
  double start_tangent = 0, end_tangent = 0;
  line_cuts_.clear();
  if (last_coverer_ >= 0 && last_coverer_ != index) add_line_cut<kWide>(e, last_coverer_);
  if (!corner(index).reflex) {
    if (edge(e.previous).run == e.run) {
      start_tangent = corner(index).half_tangent;
    } else {
      add_line_cut<kWide>(e, e.previous);
    }
  }
  if (!corner(e.next).reflex) {
    if (edge(e.next).run == e.run) {
      end_tangent = corner(e.next).half_tangent;
    } else {
      add_line_cut<kWide>(e, e.next);
    }
  }
  const auto cut_at = [&](double depth) {
    span_.reset({depth * start_tangent, before}, {e.length - depth * end_tangent, after},
                tolerance_of(e.length + depth));
    for (const LineCut& cut : line_cuts_.all()) {
      if (cut_line(cut, depth) == Left::kNothing) return Left::kNothing;
    }
    return Left::kSome;
  };
  // The edges so far tell that nothing is left at the deeper ones.
  std::size_t count = depths_.size();
  while (count > 0 && cut_at(depths_[count - 1]) == Left::kNothing) --count;
  if (count == 0) return;
  reach_ = depths_[count - 1];
  for (std::size_t at = 0; at < count; ++at) {
    if (count > 1 && cut_at(depths_[at]) == Left::kNothing) return;
    if (at == 0 && gather_line_cuts<kWide>(index, near) == Left::kNothing) return;
    span_.pieces(2 * index, pieces_[at]);
  }
}

OffsetTrim::Left OffsetTrim::cut_line(const LineCut& cut, double depth) {
  cut.apply(depth, span_);
  if (!span_.dead()) return Left::kSome;
  last_coverer_ = cut.edge();
  return Left::kNothing;
}

template <bool kWide>
void OffsetTrim::add_line_cut(const OffsetEdge& e, std::int32_t other) {
  const OffsetEdge& f = edge(other);
  const EndBeside start = beside<kWide>(e, f.x, f.y);
  const EndBeside end = beside<kWide>(e, f.x + f.dx, f.y + f.dy);
  if (start.above <= 0 && end.above <= 0) return;
  line_cuts_.next().set<kWide>(e, f, start, end, sites(other));
  line_cuts_.keep();
}

// Hands on the chunks that may reach what is left of the line, here and deeper.
template <bool kWide>
OffsetTrim::Left OffsetTrim::gather_line_cuts(std::int32_t index,
                                              std::span<const std::int32_t> near) {
  const OffsetEdge& e = edge(index);
  const double ux = e.dx * e.inverse_length, uy = e.dy * e.inverse_length;
  const double x = e.x - uy * reach_, y = e.y + ux * reach_;
  const double reach_squared = (reach_ + 1) * (reach_ + 1);
  double lo = 0, hi = -1;
  OffsetBox box{};
  for (const std::int32_t c : near) {
    const OffsetChunk& chunk = search_->chunks()[static_cast<std::size_t>(c)];
    if (chunk.run >= 0 && chunk.run == e.run) continue;
    if (lo != span_.lo() || hi != span_.hi()) {
      lo = span_.lo();
      hi = span_.hi();
      box = {x + ux * lo, y + uy * lo, x + ux * lo, y + uy * lo};
      box.add(x + ux * hi, y + uy * hi);
    }
    if (box.distance_squared(chunk.box) > reach_squared) continue;
    if (gather_line_cuts<kWide>(index, chunk) == Left::kNothing) return Left::kNothing;
  }
  return Left::kSome;
}

template <bool kWide>
OffsetTrim::Left OffsetTrim::gather_line_cuts(std::int32_t index, const OffsetChunk& chunk) {
  const OffsetEdge& e = edge(index);
  const OffsetEdge* f = &edge(chunk.first);
  EndBeside end = beside<kWide>(e, f->x, f->y);
  for (std::int32_t i = chunk.first; i < chunk.last; ++i, ++f) {
    const EndBeside start = end;
    end = beside<kWide>(e, f->x + f->dx, f->y + f->dy);
    if (start.above <= 0 && end.above <= 0) continue;
    if (start.above >= 2 * reach_ && end.above >= 2 * reach_) continue;
    if (i == index || i == e.previous || i == e.next) continue;  // cut already
    // Beyond what is left, it reaches that only if it covers its end.
    if (start.along >= span_.hi() && end.along >= span_.hi()) {
      if (!covers(start, end, span_.hi(), reach_)) continue;
    } else if (start.along <= span_.lo() && end.along <= span_.lo()) {
      if (!covers(start, end, span_.lo(), reach_)) continue;
    }
    LineCut& cut = line_cuts_.next();
    cut.set<kWide>(e, *f, start, end, sites(i));
    line_cuts_.keep();
    if (cut_line(cut, depths_.front()) == Left::kNothing) return Left::kNothing;
  }
  return Left::kSome;
}

void OffsetTrim::add_whole_arc(std::int32_t index) {
  for (std::size_t at = 0; at < depths_.size(); ++at) {
    pieces_[at].add({-1, 2 * edge(index).previous, 2 * index, 2 * index + 1, -1});
  }
}

template <bool kWide>
bool OffsetTrim::trim_arc(std::int32_t index, std::span<const std::int32_t> near) {
  const OffsetEdge& g = edge(index);
  arc_cuts_.clear();
  Left left = Left::kSome;
  std::size_t count = depths_.size();
  reach_ = depths_.back();
  if (last_coverer_ >= 0 && last_coverer_ != index && last_coverer_ != g.previous) {
    const OffsetEdge& f = edge(last_coverer_);
    const bool starts_here = f.x == g.x && f.y == g.y;
    const bool ends_here = f.x + f.dx == g.x && f.y + f.dy == g.y;
    if (starts_here || ends_here) {
      left = contours_->mended() ? Left::kSome : Left::kUnknown;
    } else {
      left = add_arc_cut<kWide>(index, last_coverer_);
    }
  }
  if (left == Left::kSome && !arc_cuts_.all().empty() && count > 1) {
    while (count > 1 && cut_arc_at(index, depths_[count - 1]) == Left::kNothing) --count;
    reach_ = depths_[count - 1];
    left = cut_arc_at(index, depths_.front());
  }
  if (left == Left::kSome) left = gather_arc_cuts<kWide>(index, near);
  if (left != Left::kSome) return left == Left::kNothing;
  if (arc_cuts_.all().empty()) {
    add_whole_arc(index);
    return true;
  }
  span_.pieces(2 * index + 1, pieces_[0]);
  for (std::size_t at = 1; at < count; ++at) {
    if (cut_arc_at(index, depths_[at]) == Left::kNothing) return true;
    span_.pieces(2 * index + 1, pieces_[at]);
  }
  return true;
}

OffsetTrim::Left OffsetTrim::cut_arc_at(std::int32_t index, double depth) {
  start_arc(index, depth);
  for (const ArcCut& cut : arc_cuts_.all()) {
    if (cut_arc(cut, depth) == Left::kNothing) return Left::kNothing;
  }
  return Left::kSome;
}

void OffsetTrim::start_arc(std::int32_t index, double depth) {
  const double k = arc_.quarter_tangent;
  span_.reset({-k, 2 * edge(index).previous}, {k, 2 * index}, tolerance_of(depth) / (2 * depth));
}

OffsetTrim::Left OffsetTrim::cut_arc(const ArcCut& cut, double depth) {
  cut.apply(depth, arc_, span_);
  if (!span_.dead()) return Left::kSome;
  last_coverer_ = cut.edge();
  return Left::kNothing;
}

// Cuts at the first depth. REQUIRES: the corner is no end of the other edge.
template <bool kWide>
OffsetTrim::Left OffsetTrim::add_arc_cut(std::int32_t index, std::int32_t other) {
  const OffsetEdge& g = edge(index);
  ArcCut& cut = arc_cuts_.next();
  if (!cut.set<kWide>(g.x, g.y, edge(other), reach_)) return Left::kSome;
  cut.set_sites(sites(other));
  if (arc_cuts_.all().empty()) {
    arc_ = contours_->arc(index);
    start_arc(index, depths_.front());
  }
  arc_cuts_.keep();
  return cut_arc(cut, depths_.front());
}

template <bool kWide>
OffsetTrim::Left OffsetTrim::gather_arc_cuts(std::int32_t index,
                                             std::span<const std::int32_t> near) {
  const OffsetEdge& g = edge(index);
  const OffsetEdge& e = edge(g.previous);
  // The arc's box: its ends and how far it bulges over their chord, at most.
  const double t = corner(index).half_tangent;
  const double bulge = 1 + reach_ * std::min(1.0, t * t / 2);
  const double ex = g.x - e.dy * e.inverse_length * reach_;
  const double ey = g.y + e.dx * e.inverse_length * reach_;
  OffsetBox box{ex, ey, ex, ey};
  box.add(g.x - g.dy * g.inverse_length * reach_, g.y + g.dx * g.inverse_length * reach_);
  const double reach_squared = (reach_ + bulge) * (reach_ + bulge);
  const bool inside_run = g.run == e.run;
  for (const std::int32_t c : near) {
    const OffsetChunk& chunk = search_->chunks()[static_cast<std::size_t>(c)];
    if (inside_run && chunk.run == g.run) continue;
    if (box.distance_squared(chunk.box) > reach_squared) continue;
    const Left left = gather_arc_cuts<kWide>(index, chunk);
    if (left != Left::kSome) return left;
  }
  return Left::kSome;
}

// Leaves out the chunk's edges that lie behind the arc: below both tangents' normals.
template <bool kWide>
OffsetTrim::Left OffsetTrim::gather_arc_cuts(std::int32_t index, const OffsetChunk& chunk) {
  const OffsetEdge& g = edge(index);
  const OffsetEdge& e = edge(g.previous);
  const OffsetEdge* f = &edge(chunk.first);
  double x = f->x - g.x, y = f->y - g.y;
  bool ahead = exact_cross<kWide>(e.dx, e.dy, x, y) > 0 || exact_cross<kWide>(g.dx, g.dy, x, y) > 0;
  const double reach = 2 * reach_;
  for (std::int32_t i = chunk.first; i < chunk.last; ++i, ++f) {
    const bool start_ahead = ahead;
    const double x1 = x, y1 = y;
    x = f->x + f->dx - g.x;
    y = f->y + f->dy - g.y;
    ahead = exact_cross<kWide>(e.dx, e.dy, x, y) > 0 || exact_cross<kWide>(g.dx, g.dy, x, y) > 0;
    const bool here = (x == 0 && y == 0) || (x1 == 0 && y1 == 0);
    if ((!start_ahead && !ahead && !here) || i == index || i == g.previous) continue;
    if (here) {  // at a wedge: never nearer
      if (!contours_->mended()) return Left::kUnknown;
      continue;
    }
    if ((x > reach && x1 > reach) || (x < -reach && x1 < -reach) || (y > reach && y1 > reach) ||
        (y < -reach && y1 < -reach)) {
      continue;
    }
    if (add_arc_cut<kWide>(index, i) == Left::kNothing) return Left::kNothing;
  }
  return Left::kSome;
}

}  // namespace core
