// Which layers of the window decide the wall of a layer: those within the wall's reach.
//
//     cylinder   T layers up and T layers down
//     ball       all whose near face is nearer than w to the layer's mid-plane; heights may differ
//
// The bed and the end of the part count as outside: where the wall reaches them, all is wall.
#pragma once

#include <cstddef>

#include "core/settings.h"      // Settings
#include "core/slices/slice.h"  // Slice
#include "core/units.h"         // Length

namespace core {

class WallReach {
 public:
  // REQUIRES: settings validated.
  explicit WallReach(const Settings& settings);
  // A ball's. REQUIRES: wall_thickness > 0.
  explicit WallReach(Length wall_thickness) : wall_thickness_(wall_thickness) {}

  // Whether the layer `to` decides the wall of the layer `from`.
  [[nodiscard]] bool includes(const Slice& from, const Slice& to) const;
  // Whether what is below the bed does.
  [[nodiscard]] bool includes_bed(const Slice& from) const;
  // Whether no layer above `newest` does.
  [[nodiscard]] bool ends_within(const Slice& newest, const Slice& from) const;

  // How deep the wall reaches into the layer `to`. REQUIRES: includes(from, to).
  [[nodiscard]] Length depth(const Slice& from, const Slice& to) const;

 private:
  Length wall_thickness_;
  int layers_ = 0;  // T of a cylinder; 0: a ball
};

// Visits the layers of a window from `centre` outwards: itself, then the next ones up and down in
// turn. A direction ends at the window's end, or where visit(number) returns false.
template <typename Visit>
void visit_outwards(std::size_t count, std::size_t centre, Visit visit) {
  if (!visit(centre)) return;
  bool up = true, down = true;
  for (std::size_t i = 1; up || down; ++i) {
    up = up && centre + i < count && visit(centre + i);
    down = down && i <= centre && visit(centre - i);
  }
}

}  // namespace core
