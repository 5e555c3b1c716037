#include "tests/support/cell_stacks.h"

#include "core/booleans/boolean.h"         // clean
#include "tests/support/random_regions.h"  // Random
#include "tests/support/region_text.h"     // rectangle_region

namespace test {
namespace {

constexpr double kCell_mm = 2;

}  // namespace

core::Region region_of_cells(const Cells& cells) {
  std::vector<core::Ring> rings;
  for (std::size_t y = 0; y < kCells; ++y) {
    for (std::size_t x = 0; x < kCells; ++x) {
      if (!cells[y * kCells + x]) continue;
      const core::Region cell = rectangle_region(
          static_cast<double>(x) * kCell_mm, static_cast<double>(y) * kCell_mm, kCell_mm, kCell_mm);
      rings.push_back(cell.rings().front());
    }
  }
  return core::clean(rings, core::FillRule::kPositive);
}

std::vector<core::Region> regions_of(const std::vector<Cells>& stack) {
  std::vector<core::Region> slices;
  for (const Cells& cells : stack) slices.push_back(region_of_cells(cells));
  return slices;
}

std::vector<Cells> random_cells(std::uint64_t seed, int layers, double share) {
  Random random(seed);
  std::vector<Cells> stack(static_cast<std::size_t>(layers), Cells(kCells * kCells));
  for (Cells& cells : stack) {
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = random.unit() < share;
  }
  return stack;
}

core::Settings settings_of_cells() {
  core::Settings settings;
  settings.supports = core::SupportPlace::kEverywhere;
  settings.support_top_gap_layers = 0;
  settings.support_bottom_gap_layers = 0;
  settings.support_xy_distance = core::Length();
  settings.support_interface_layers = 0;
  settings.support_bottom_interface_layers = 0;
  settings.support_base_expansion = core::Length();
  settings.support_area_min_mm2 = 0;
  settings.support_section_min = core::Length();
  settings.bridge_max = core::Length();
  settings.road_width_min = core::Length::from_mm(0.1);
  return settings;
}

}  // namespace test
