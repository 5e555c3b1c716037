// A layer file, written layer by layer.
#pragma once

#include <string>
#include <vector>

#include "core/roads/road.h"         // Road
#include "core/units.h"              // LayerIndex, Length
#include "core/walls/split_layer.h"  // SplitLayer

namespace host {

// What of a layer a file is to hold.
enum class LayerContents {
  kSlices,              // the part itself
  kWalls,               // its wall, then its inside, told apart as far as the format can
  kWallsForQuickSlice,  // the same; contours that both share stand with the inside's, both copies
                        // (slice_v0_writer.h)
};

// What is known before the first layer.
struct LayerFileHead {
  core::LayerIndex layers = 0;  // 0: not known
  core::Length layer_height;    // as set; layers have their own
  core::Length bed_x;
  core::Length bed_y;
  LayerContents contents = LayerContents::kWalls;
};

class LayerWriter {
 public:
  virtual ~LayerWriter() = default;

  // Each appends what is to be written next. In this order: begin, layers from the bed up, end.
  virtual void begin(std::string& into) = 0;
  virtual void layer(const core::SplitLayer& layer, const std::vector<core::Road>& roads,
                     std::string& into) = 0;
  virtual void end(std::string& into) = 0;

  // Whether layer() is to be given the roads; otherwise there are none.
  [[nodiscard]] virtual bool wants_roads() const { return false; }
};

}  // namespace host
