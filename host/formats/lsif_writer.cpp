#include "host/formats/lsif_writer.h"

#include <cstdint>

#include "host/formats/number_text.h"  // append_mm

namespace host {
namespace {

using core::Ring;

class LsifWriter : public LayerWriter {
 public:
  explicit LsifWriter(const LayerFileHead& head) : head_(head) {}

  void begin(std::string& into) override {
    into += "(LSIF 1 0 (units mm) (desired_accuracy 0.0001) (thickness ";
    append_mm(head_.layer_height.units(), into);
    into += ") (offset 0)\n";
  }

  void layer(const core::SplitLayer& layer, const std::vector<core::Road>&,
             std::string& into) override {
    const core::Slice& slice = layer.slice;
    into += "(layer";
    if (slice.height != head_.layer_height) {
      into += " (thickness ";
      append_mm(slice.height.units(), into);
      into += ')';
    }
    into += '\n';
    vertices_ = 0;
    const std::string part = region_set(slice.region, into);
    const bool split = head_.contents != LayerContents::kSlices && !layer.loose.empty();
    if (!split) {
      into += part;
    } else {
      const std::string inside = region_set(layer.loose, into);
      into += "(difference " + part + inside + ")" + inside;
    }
    into += ")\n";
  }

  void end(std::string& into) override { into += ")\n"; }

 private:
  // Appends the region's vertices to `into`, and returns the region as a set.
  std::string region_set(const core::Region& region, std::string& into) {
    std::string set = "(union";
    for (const core::Island& island : core::islands(region)) {
      set += "\n (nested1d";
      append_contour(island.outer, set, into);
      for (const Ring& hole : island.holes) append_contour(hole, set, into);
      set += ')';
    }
    return set + ")\n";
  }

  void append_contour(const Ring& ring, std::string& set, std::string& vertices) {
    set += " (contour";
    for (const core::Point point : ring) {
      const std::string id = std::to_string(++vertices_);
      set += ' ' + id;
      vertices += "(v " + id + ' ';
      append_mm(point.x, vertices);
      vertices += ' ';
      append_mm(point.y, vertices);
      vertices += ")\n";
    }
    set += ')';
  }

  LayerFileHead head_;
  std::int64_t vertices_ = 0;  // of this layer
};

}  // namespace

std::unique_ptr<LayerWriter> lsif_writer(const LayerFileHead& head) {
  return std::make_unique<LsifWriter>(head);
}

}  // namespace host
