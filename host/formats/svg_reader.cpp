#include "host/formats/svg_reader.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

#include "core/units.h"                   // Length
#include "host/formats/number_text.h"     // parse_real
#include "host/formats/svg_path.h"        // add_svg_path
#include "host/formats/text_scanner.h"    // shown
#include "host/formats/xml_file_bytes.h"  // xml_bytes_of
#include "host/formats/xml_scanner.h"     // XmlScanner

namespace host {
namespace {

using core::Length;
using core::Result;
using core::Slice;
using core::Status;

constexpr const char* kZ = "http://slic3r.org/namespaces/slic3r|z";
constexpr const char* kHeight = "http://slic3r.org/namespaces/slic3r|layer-height";
constexpr const char* kType = "http://slic3r.org/namespaces/slic3r|type";
constexpr double kSlic3rFactor = 1e6;

class SvgReader : public LayerReader {
 public:
  explicit SvgReader(InputFile file)
      : name_(file.name()), xml_(name_, xml_bytes_of(std::move(file)), false) {}

  [[nodiscard]] std::string format() const override { return "SVG layers"; }

  [[nodiscard]] Status open() {
    const Result<const XmlEvent*> event = xml_.next();
    if (!event.ok()) return event.error();
    if (event.value() == nullptr || event.value()->name != "svg") {
      return xml_.bad("no <svg> at the document's root; this is no SVG");
    }
    if (const std::string* height = event.value()->attribute("height")) {
      std::string_view text = *height;
      if (text.ends_with("mm")) text.remove_suffix(2);
      axis_height_ = parse_real(text);
    }
    return {};
  }

  [[nodiscard]] Result<std::optional<Slice>> next() override {
    while (true) {
      const Result<const XmlEvent*> event = xml_.next();
      if (!event.ok()) return event.error();
      if (event.value() == nullptr) {
        if (index_ > 0) return std::optional<Slice>();
        return xml_.bad(
            "there is no <g slic3r:z=…> in the file, so it has no layers; export it "
            "from Slic3r, or as STL");
      }
      if (event.value()->kind != XmlEvent::Kind::kStart) continue;
      if (Status plain = check_plain(*event.value()); !plain.ok()) return plain.error();
      if (const std::string* z = event.value()->attribute(kZ); z != nullptr) {
        const std::string* height = event.value()->attribute(kHeight);
        if (Status set = set_faces(*z, height); !set.ok()) return set.error();
        if (Status read = read_layer(); !read.ok()) return read.error();
        Slice slice;
        slice.index = index_++;
        slice.bottom = Length::from_units(bottom_);
        slice.height = Length::from_units(top_ - bottom_);
        slice.region = layer_.take(core::FillRule::kPositive);
        return std::optional<Slice>(std::move(slice));
      }
    }
  }

 private:
  // The faces of the layer that starts; bottom_ and top_ are still those of the one before.
  [[nodiscard]] Status set_faces(const std::string& z_text, const std::string* height_text) {
    std::optional<double> z = parse_real(z_text);
    const std::optional<double> height = height_text ? parse_real(*height_text) : 0.0;
    if (!z || !height || (height_text && *height <= 0)) {
      return xml_.bad("'" + shown(z ? *height_text : z_text) +
                      "' is no height of a layer; export the file again");
    }
    if (index_ == 0 && !height_text && *z > 0 && *z < kSvgLowestMm) {
      factor_ = kSlic3rFactor;
      warn(name_ + ": heights were taken times 10^6, as Slic3r 1.3 means them");
    }
    *z *= factor_;
    const std::int64_t below = index_ > 0 ? top_ : 0;
    const double below_mm = Length::from_units(below).mm();
    const double top_mm = height_text ? *z : 2 * *z - below_mm;
    const std::optional<std::int64_t> top = height_units(top_mm);
    const std::optional<std::int64_t> bottom = height_units(height_text ? *z - *height : below_mm);
    if (!top || !bottom || *top <= *bottom || (index_ > 0 && *top <= below)) {
      return xml_.bad("a layer at " + number_text(*z) +
                      " mm does not lie above the one before; export the file again");
    }
    const double slack = kSvgGapMax * static_cast<double>(*top - *bottom);
    if (index_ > 0 && static_cast<double>(std::abs(*bottom - below)) > std::ceil(slack)) {
      return xml_.bad("a layer begins at " + number_text(Length::from_units(*bottom).mm()) +
                      " mm, the one below ends at " + number_text(below_mm) +
                      " mm; export the file again");
    }
    bottom_ = index_ > 0 ? below : *bottom;
    top_ = *top;
    return {};
  }

  // Reads to the end of its <g>.
  [[nodiscard]] Status read_layer() {
    for (int open = 1; open > 0;) {
      const Result<const XmlEvent*> event = xml_.next();
      if (!event.ok()) return event.error();
      if (event.value() == nullptr) return xml_.bad("the document ends within a layer");
      if (event.value()->kind == XmlEvent::Kind::kEnd) {
        --open;
        continue;
      }
      ++open;
      if (Status taken = take_shape(*event.value()); !taken.ok()) return taken;
    }
    return {};
  }

  [[nodiscard]] Status check_plain(const XmlEvent& event) const {
    if (event.attribute("transform") == nullptr) return {};
    return xml_.bad("<" + shown(event.name) +
                    " transform=…> is not supported; apply transforms before exporting");
  }

  [[nodiscard]] Status take_shape(const XmlEvent& event) {
    if (Status plain = check_plain(event); !plain.ok()) return plain;
    std::string cause;
    if (event.name == "polygon") {
      const std::string* points = event.attribute("points");
      const std::string* type = event.attribute(kType);
      const bool hole = type != nullptr && *type == "hole";
      if (points == nullptr) return {};
      cause =
          add_svg_points(*points, {}, hole ? Turn::kClockwise : Turn::kCounterClockwise, layer_);
    } else if (event.name == "path") {
      const std::string* data = event.attribute("d");
      if (data == nullptr) return {};
      if (!axis_height_) {
        return xml_.bad("<svg> has no height in mm, from which paths count down; export it again");
      }
      cause = add_svg_path(*data, {true, *axis_height_}, path_);
      if (cause.empty()) cause = layer_.add(path_.take(core::FillRule::kEvenOdd));
    } else if (event.name != "g" && event.name != "title" && event.name != "desc" && !told_) {
      told_ = true;
      warn(name_ + ": <" + shown(event.name) +
           "> and other shapes but paths and polygons were left out");
    }
    return cause.empty() ? Status() : xml_.bad(cause);
  }

  std::string name_;
  XmlScanner xml_;
  std::optional<double> axis_height_;
  double factor_ = 1;
  ContourGatherer path_;
  ContourGatherer layer_;
  std::int64_t bottom_ = 0;
  std::int64_t top_ = 0;
  core::LayerIndex index_ = 0;
  bool told_ = false;
};

}  // namespace

Result<std::unique_ptr<LayerReader>> open_svg(InputFile file) {
  auto reader = std::make_unique<SvgReader>(std::move(file));
  if (Status opened = reader->open(); !opened.ok()) return opened.error();
  return std::unique_ptr<LayerReader>(std::move(reader));
}

}  // namespace host
