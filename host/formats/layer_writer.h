// Plug point: writes a layer file, layer by layer.
#pragma once

#include <string>
#include <vector>

#include "core/roads/road.h"         // Road
#include "core/units.h"              // LayerIndex, Length
#include "core/walls/split_layer.h"  // SplitLayer

namespace host {

// Which regions of a layer are written.
enum class LayerContents {
  kSlices,              // the part itself
  kWalls,               // its wall, then its inside, marked as such if the format can
  kWallsForQuickSlice,  // the same, but both copies of a contour that they share are among the
                        // inside's (slice_v0_writer.h)
};

// Known before the first layer.
struct LayerFileHead {
  core::LayerIndex layers = 0;  // 0: not known
  core::Length layer_height;    // the setting; each layer has its own
  core::Length bed_x;
  core::Length bed_y;
  LayerContents contents = LayerContents::kWalls;
};

class LayerWriter {
 public:
  virtual ~LayerWriter() = default;

  // Each appends the next piece of the file. In this order: begin, layers from the bed up, end.
  virtual void begin(std::string& into) = 0;
  virtual void layer(const core::SplitLayer& layer, const std::vector<core::Road>& roads,
                     std::string& into) = 0;
  virtual void end(std::string& into) = 0;

  // Whether layer() needs the roads; if not, it gets none.
  [[nodiscard]] virtual bool wants_roads() const { return false; }
};

}  // namespace host
