#include "host/cli_writer.h"

#include <fmt/format.h>

#include <iterator>

namespace host {
namespace {

void write_region(const core::Region& region, int label, std::string& into) {
  const auto out = std::back_inserter(into);
  for (const core::Ring& ring : region.rings()) {
    const int direction = core::doubled_area_units(ring) > 0 ? 1 : 0;
    // Closed means that the first point is said again at the end.
    fmt::format_to(out, "$$POLYLINE/{},{},{}", label, direction, ring.size() + 1);
    const auto write_point = [&out](core::Point point) {
      fmt::format_to(out, ",{},{}", core::Length::from_units(point.x).mm(),
                     core::Length::from_units(point.y).mm());
    };
    for (const core::Point point : ring) write_point(point);
    write_point(ring.front());
    into += '\n';
  }
}

}  // namespace

void write_cli_header(core::LayerIndex layers, std::string& into) {
  fmt::format_to(std::back_inserter(into),
                 "$$HEADERSTART\n$$ASCII\n$$UNITS/1.0\n$$VERSION/200\n{}"
                 "$$LABEL/1,\"solid\"\n$$LABEL/2,\"loose\"\n$$HEADEREND\n$$GEOMETRYSTART\n",
                 layers > 0 ? fmt::format("$$LAYERS/{}\n", layers) : "");
}

void write_cli_layer(const core::SplitLayer& layer, std::string& into) {
  fmt::format_to(std::back_inserter(into), "$$LAYER/{}\n", layer.layer.slice.top().mm());
  write_region(layer.solid, 1, into);
  write_region(layer.loose, 2, into);
}

void write_cli_end(std::string& into) { into += "$$GEOMETRYEND\n"; }

}  // namespace host
