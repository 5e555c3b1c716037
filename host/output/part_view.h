// Looks at a part from the front, the left and above, while its facets come by.
//
// Each facet is drawn once, into a depth buffer of kCells × kCells, before anyone knows how large
// the part is. The cells lie on a lattice about the origin. Where a facet does not fit into the
// buffer, the cells become twice as large: of four, the nearest is kept.
//
//     ┌─┬─┬─┬─┐  a facet       ┌───┬───┐┄┄┄┄
//     ├─┼─┼─┼─┤  beyond it     │   │   │   ┊   the same memory,
//     ├─┼─┼─┼─┤  ───────────>  ├───┼───┤┄┄┄    twice the view
//     └─┴─┴─┴─┘                └───┴───┘
//
// A facet marks the cells whose centres it covers. One that is narrower than cells marks a cell in
// each row (or column) along its length; a small one marks one cell. So a picture is right to
// within a cell. In the end, the part's longer side takes more than kCells / 2 cells, unless the
// part is smaller than 1 mm. Parts that are inside out, or open, look the same from outside: both
// sides of a facet are drawn.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "core/geometry.h"             // Triangle
#include "host/output/rgba_picture.h"  // RgbaPicture

namespace host {

class PartView {
 public:
  static constexpr int kCells = 512;
  // Its memory, whatever it sees. Cells that nothing was drawn into cost the system less.
  static constexpr std::size_t kBytes = std::size_t{kCells} * kCells * (sizeof(float) + 1);

  PartView();

  // COSTS: the cells that the facet covers; it allocates nothing. A cell becomes larger, or the
  // view is moved, at most about 1,000 times in all (once in 2^50 of size, and 20 moves each).
  void add(const core::Triangle& triangle);

  // No facet had an area.
  [[nodiscard]] bool empty() const { return whole_.left > whole_.right; }

  // The part in the picture's middle, as large as fits with a margin of 1/32 of the picture's
  // shorter side; each pixel is the mean of the cells under it. The background is transparent.
  // REQUIRES: both sides are >= 1 pixel.
  [[nodiscard]] RgbaPicture picture(int width, int height) const;

 private:
  // A corner, seen from the viewer's place: in units, or in cells from the buffer's corner.
  struct Corner {
    double across = 0;  // to the right
    double up = 0;
    double near = 0;  // towards the viewer, in units
  };
  // In cells of the lattice; both ends belong to it.
  struct Cells {
    std::int64_t left, right, low, high;
  };

  // In units, or in cells from the buffer's corner. Empty by default.
  struct Extent {
    double left = 1, right = 0, low = 1, high = 0;

    [[nodiscard]] bool holds(const Extent& other) const {
      return other.left >= left && other.right <= right && other.low >= low && other.high <= high;
    }
  };
  // The row, or column; where in it; how near.
  using Place = std::array<double, 3>;
  class Face;

  [[nodiscard]] static Corner seen(const core::Vertex& vertex);
  [[nodiscard]] Cells cells_of(const Extent& extent) const;
  [[nodiscard]] static std::size_t cell_at(std::int64_t row, std::int64_t place, bool by_columns);
  void make_room(const Extent& extent);
  void double_cells();
  void move_to(std::int64_t left, std::int64_t low);
  // The places in ascending order of rows.
  void draw(const std::array<Place, 3>& points, std::int64_t first, std::int64_t last,
            bool by_columns, Face& face);
  // If nothing there is nearer.
  void mark(std::size_t cell, double near, Face& face) {
    const auto distance = static_cast<float>(near);
    if (shade_[cell] == 0 || near_[cell] < distance) show(cell, distance, face);
  }
  void show(std::size_t cell, float near, Face& face);

  std::unique_ptr<float[]> near_;                // of cells with a shade; rows from below
  std::unique_ptr<std::uint8_t[]> shade_;        // 0: nothing is there
  double cell_;                                  // a cell's side, in units
  Cells used_{};                                 // what was drawn lies within
  std::int64_t first_left_ = 0, first_low_ = 0;  // the buffer's first cell, on the lattice
  Extent whole_;                                 // of the part, in units
};

}  // namespace host
