#include "host/formats/svg_writer.h"

#include "host/formats/number_text.h"  // append_mm

namespace host {
namespace {

using core::Ring;

class SvgWriter : public LayerWriter {
 public:
  explicit SvgWriter(const LayerFileHead& head) : head_(head) {}

  void begin(std::string& into) override {
    into += "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg width=\"";
    append_mm(head_.bed_x.units(), into);
    into += "\" height=\"";
    append_mm(head_.bed_y.units(), into);
    into +=
        "\" xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:slic3r=\"http://slic3r.org/namespaces/slic3r\">\n";
  }

  void layer(const core::SplitLayer& layer, const std::vector<core::Road>&,
             std::string& into) override {
    const core::Slice& slice = layer.slice;
    into += "<g id=\"layer" + std::to_string(slice.index) + "\" slic3r:z=\"";
    append_mm(slice.top().units(), into);
    into += "\" slic3r:slice-z=\"";
    append_mm(slice.bottom.units() + slice.height.units() / 2, into);
    into += "\" slic3r:layer-height=\"";
    append_mm(slice.height.units(), into);
    into += "\">\n";
    if (head_.contents == LayerContents::kSlices) {
      append_region(slice.region, "", into);
    } else {
      append_region(layer.solid, "class=\"solid\" ", into);
      append_region(layer.loose, "class=\"loose\" fill=\"#ccc\" ", into);
    }
    into += "</g>\n";
  }

  void end(std::string& into) override { into += "</svg>\n"; }

 private:
  void append_region(const core::Region& region, const char* style, std::string& into) const {
    for (const core::Island& island : core::islands(region)) {
      into += "<path ";
      into += style;
      into += "fill-rule=\"evenodd\" d=\"";
      append_ring(island.outer, into);
      for (const Ring& hole : island.holes) {
        into += ' ';
        append_ring(hole, into);
      }
      into += "\"/>\n";
    }
  }

  void append_ring(const Ring& ring, std::string& into) const {
    into += 'M';
    for (const core::Point point : ring) {
      into += ' ';
      append_mm(point.x, into);
      into += ' ';
      append_mm(head_.bed_y.units() - point.y, into);
    }
    into += " z";
  }

  LayerFileHead head_;
};

}  // namespace

std::unique_ptr<LayerWriter> svg_writer(const LayerFileHead& head) {
  return std::make_unique<SvgWriter>(head);
}

}  // namespace host
