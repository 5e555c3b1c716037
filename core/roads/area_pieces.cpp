#include "core/roads/area_pieces.h"

#include <algorithm>
#include <utility>

#include "core/regions/polyline.h"  // between, distance_mm

namespace core {
namespace {

constexpr Length kCell = Length::from_units(10'000);

void append(AreaPiece more, AreaPiece& piece) {
  piece.points.insert(piece.points.end(), more.points.begin() + 1, more.points.end());
  piece.places.insert(piece.places.end(), more.places.begin() + 1, more.places.end());
  piece.length_mm += more.length_mm;
}

// What is too short goes with what is beside it.
std::vector<AreaPiece> without_short(std::vector<AreaPiece> pieces) {
  const auto is_short = [](const AreaPiece& piece) { return piece.length_mm < kAreaPieceMin.mm(); };
  std::vector<AreaPiece> kept;
  for (AreaPiece& piece : pieces) {
    const bool joins = !kept.empty() &&
                       (is_short(piece) || is_short(kept.back()) || kept.back().area == piece.area);
    if (!joins) {
      kept.push_back(std::move(piece));
      continue;
    }
    if (is_short(kept.back())) kept.back().area = piece.area;
    append(std::move(piece), kept.back());
  }
  return kept;
}

}  // namespace

AreaPieces::AreaPieces(const std::vector<Region>& areas) {
  for (const Region& area : areas) {
    const std::vector<Segment> edges = edges_of(area.rings());
    edges_.insert(edges_.end(), edges.begin(), edges.end());
    areas_.emplace_back(area);
  }
  if (!edges_.empty()) grid_.emplace(kCell, edges_);
}

int AreaPieces::area_at(Point point) const {
  for (std::size_t i = 0; i < areas_.size(); ++i) {
    if (areas_[i].contains(point)) return static_cast<int>(i);
  }
  return AreaPiece::kNoArea;
}

// Shares of the way at which it meets a border, in their order.
std::vector<double> AreaPieces::crossings(const Segment& way) const {
  std::vector<double> shares;
  if (!grid_) return shares;
  std::vector<std::uint32_t> near;
  grid_->collect_along(way, near);
  for (const std::uint32_t number : near) {
    const Segment& edge = edges_[number];
    const auto from = static_cast<double>(cross(edge.from, edge.to, way.from));
    const auto to = static_cast<double>(cross(edge.from, edge.to, way.to));
    if (from == to) continue;  // along the border, whose next edges cross the way
    shares.push_back(std::clamp(from / (from - to), 0.0, 1.0));
  }
  std::sort(shares.begin(), shares.end());
  return shares;
}

std::vector<AreaPiece> AreaPieces::cut(const std::vector<Point>& line) const {
  std::vector<AreaPiece> pieces;
  const auto add = [&](int area, Point from, double from_place, Point to, double to_place) {
    if (pieces.empty() || pieces.back().area != area) {
      pieces.push_back({area, 0, {from}, {from_place}});
    }
    pieces.back().points.push_back(to);
    pieces.back().places.push_back(to_place);
    pieces.back().length_mm += distance_mm(from, to);
  };
  bool goes_on = false;  // the piece at hand is known to, where no border is met
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Segment way{line[i - 1], line[i]};
    if (way.from == way.to) continue;
    const std::vector<double> shares = crossings(way);
    Point last = way.from;
    auto last_place = static_cast<double>(i - 1);
    for (std::size_t k = 0; k <= shares.size(); ++k) {
      const double share = k < shares.size() ? shares[k] : 1;
      const Point next = between(way.from, way.to, share);
      if (next == last) continue;
      const double place = static_cast<double>(i - 1) + share;
      const bool same = goes_on && shares.empty();
      add(same ? pieces.back().area : area_at(between(last, next, 0.5)), last, last_place, next,
          place);
      last = next;
      last_place = place;
    }
    goes_on = shares.empty();
  }
  return without_short(std::move(pieces));
}

}  // namespace core
