#include "host/output/raster_canvas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/check.h"  // RIND_CHECK

namespace host {
namespace {

// From top to bottom.
struct Edge {
  double x0, y0, x1, y1;
  int winding;

  [[nodiscard]] double x_at(double y) const { return x0 + (x1 - x0) * ((y - y0) / (y1 - y0)); }
};

std::vector<Edge> edges_of(const std::vector<PixelOutline>& outlines) {
  std::vector<Edge> edges;
  for (const PixelOutline& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Pixel a = outline[i], b = outline[(i + 1) % outline.size()];
      if (a.y < b.y) edges.push_back({a.x, a.y, b.x, b.y, 1});
      if (a.y > b.y) edges.push_back({b.x, b.y, a.x, a.y, -1});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.y0 < b.y0; });
  return edges;
}

struct Crossing {
  double x;
  int winding;
};

// Adds a piece of a line to the pixels that it covers. REQUIRES: 0 <= from, to <= size
void add_piece(double from, double to, std::vector<float>& cover) {
  if (to <= from) return;
  const auto first = static_cast<std::size_t>(from);
  const auto last = std::min(static_cast<std::size_t>(to), cover.size() - 1);
  if (first == last) {
    cover[first] += static_cast<float>(to - from);
    return;
  }
  cover[first] += static_cast<float>(static_cast<double>(first) + 1 - from);
  for (std::size_t i = first + 1; i < last; ++i) cover[i] += 1;
  cover[last] += static_cast<float>(to - static_cast<double>(last));
}

}  // namespace

RasterCanvas::RasterCanvas(int width, int height) {
  RIND_CHECK(width >= 1 && height >= 1);
  picture_.width = width;
  picture_.height = height;
  picture_.bytes.assign(
      std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
  cover_.assign(static_cast<std::size_t>(width), 0);
}

void RasterCanvas::fill(const std::vector<PixelOutline>& outlines, const Paint& paint,
                        const PixelBox& clip) {
  const std::vector<Edge> edges = edges_of(outlines);
  if (edges.empty()) return;
  double bottom = edges.front().y1;
  for (const Edge& edge : edges) bottom = std::max(bottom, edge.y1);
  const double left = std::max(0.0, clip.x0);
  const double right = std::min(static_cast<double>(picture_.width), clip.x1);
  if (left >= right) return;
  const double highest = std::max({0.0, clip.y0, edges.front().y0});
  const double lowest = std::min({static_cast<double>(picture_.height), clip.y1, bottom});
  std::vector<const Edge*> active;
  std::vector<Crossing> crossings;
  std::size_t next = 0;
  for (int row = static_cast<int>(highest); row < lowest; ++row) {
    for (int line = 0; line < kRowLines; ++line) {
      const double y = row + (line + 0.5) / kRowLines;
      if (y < highest || y > lowest) continue;
      while (next < edges.size() && edges[next].y0 <= y) active.push_back(&edges[next++]);
      std::erase_if(active, [y](const Edge* edge) { return edge->y1 <= y; });
      crossings.clear();
      for (const Edge* edge : active) crossings.push_back({edge->x_at(y), edge->winding});
      std::sort(crossings.begin(), crossings.end(),
                [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
      int winding = 0;
      for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        winding += crossings[i].winding;
        if (winding == 0) continue;
        add_piece(std::clamp(crossings[i].x, left, right),
                  std::clamp(crossings[i + 1].x, left, right), cover_);
      }
    }
    blend_row(row, paint);
  }
}

void RasterCanvas::blend_row(int row, const Paint& paint) {
  std::uint8_t* at = picture_.bytes.data() + std::size_t{4} * static_cast<std::size_t>(row) *
                                                 static_cast<std::size_t>(picture_.width);
  for (float& cover : cover_) {
    if (cover > 0) {
      const double share = std::min(1.0, static_cast<double>(cover) / kRowLines) * paint.opacity;
      const auto mixed = [share](std::uint8_t under, std::uint8_t over) {
        return static_cast<std::uint8_t>(std::lround(under + share * (over - under)));
      };
      at[0] = mixed(at[0], paint.red);
      at[1] = mixed(at[1], paint.green);
      at[2] = mixed(at[2], paint.blue);
      cover = 0;
    }
    at += 4;
  }
}

}  // namespace host
