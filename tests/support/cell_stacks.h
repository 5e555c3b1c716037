// Layers of square cells, full or empty: what supports are can be counted there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/regions/region.h"  // Region
#include "core/settings.h"        // Settings

namespace test {

constexpr std::size_t kCells = 6;  // a side; 2 mm each

// What opening rounds off a cell's corners, in units.
constexpr double kCellCornerUnits = 600;

// A layer, kCells · kCells of them, row by row.
using Cells = std::vector<bool>;

core::Region region_of_cells(const Cells& cells);
std::vector<core::Region> regions_of(const std::vector<Cells>& stack);

// Each is full with a probability of `share`.
std::vector<Cells> random_cells(std::uint64_t seed, int layers, double share = 0.35);

// Supports everywhere, without gap or distance, and nothing small or bridged, so that a cell is a
// cell.
core::Settings settings_of_cells();

}  // namespace test
