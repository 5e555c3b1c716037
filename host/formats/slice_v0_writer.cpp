#include "host/formats/slice_v0_writer.h"

#include <algorithm>
#include <set>

#include "host/formats/number_text.h"  // append_inches

namespace host {
namespace {

using core::Ring;

// The points from the smallest one on, counter-clockwise: equal for both copies of a contour.
Ring shape_of(const Ring& ring) {
  Ring shape = ring;
  if (core::doubled_area_units(shape) < 0) std::reverse(shape.begin(), shape.end());
  std::rotate(shape.begin(), std::min_element(shape.begin(), shape.end()), shape.end());
  return shape;
}

class SliceV0Writer : public LayerWriter {
 public:
  explicit SliceV0Writer(const LayerFileHead& head) : head_(head) {}

  void begin(std::string& into) override { into += "Slice V0\nFILE(rind,UNITS(INCH))\nSLICES()\n"; }

  void layer(const core::SplitLayer& layer, const std::vector<core::Road>&,
             std::string& into) override {
    const core::Slice& slice = layer.slice;
    into += "Z ";
    append_inches(slice.bottom.units(), into);
    into += ' ';
    append_inches(slice.height.units(), into);
    into += '\n';
    if (head_.contents == LayerContents::kSlices) {
      for (const Ring& ring : slice.region.rings()) append_ring(ring, into);
      return;
    }
    std::set<Ring> inside;
    if (head_.contents == LayerContents::kWallsForQuickSlice) {
      for (const Ring& ring : layer.loose.rings()) inside.insert(shape_of(ring));
    }
    std::vector<const Ring*> copies;
    for (const Ring& ring : layer.solid.rings()) {
      if (!inside.empty() && inside.contains(shape_of(ring))) {
        copies.push_back(&ring);
      } else {
        append_ring(ring, into);
      }
    }
    for (const Ring* ring : copies) append_ring(*ring, into);
    for (const Ring& ring : layer.loose.rings()) append_ring(ring, into);
  }

  void end(std::string& into) override { into += "END\n"; }

 private:
  // Outer contours are counter-clockwise in regions, clockwise in this format.
  static void append_ring(const Ring& ring, std::string& into) {
    for (auto point = ring.rbegin(); point != ring.rend(); ++point) {
      append_inches(point->x, into);
      into += ' ';
      append_inches(point->y, into);
      into += '\n';
    }
    into += "C\n";
  }

  LayerFileHead head_;
};

}  // namespace

std::unique_ptr<LayerWriter> slice_v0_writer(const LayerFileHead& head) {
  return std::make_unique<SliceV0Writer>(head);
}

}  // namespace host
