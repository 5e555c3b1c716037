// Bodies of a field: where it is above 0, by marching tetrahedra.
#pragma once

#include <functional>

#include "tools/parts/part_maker.h"

namespace parts {

using Field = std::function<double(const Corner&)>;

// A box of cells from (0, 0, 0).
struct FieldGrid {
  int columns = 0;
  int rows = 0;
  int levels = 0;
  double cell = 1;  // mm
};

// Closed if the field is at most 0 all over the grid's boundary. Facets come in order of height, by
// level. COSTS: the memory of two levels.
void march(const FacetSink& sink, const Field& field, const FieldGrid& grid);

}  // namespace parts
