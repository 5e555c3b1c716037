#include "host/formats/slice_v0_reader.h"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/units.h"                     // Length
#include "host/formats/contour_gatherer.h"  // ContourGatherer
#include "host/formats/number_text.h"       // parse_real
#include "host/formats/text_scanner.h"      // TextScanner

namespace host {
namespace {

using core::Length;
using core::Result;
using core::Slice;

constexpr double kInchMm = 25.4;

// A layer's lower and upper face.
struct Faces {
  std::int64_t bottom = 0;
  std::int64_t top = 0;
};

class SliceV0Reader : public LayerReader {
 public:
  explicit SliceV0Reader(InputFile file) : text_(std::move(file)) {}

  [[nodiscard]] std::string format() const override { return "Slice V0"; }

  [[nodiscard]] core::Status open() {
    text_.skip_blanks();
    const std::string_view magic = text_.rest_of_line();
    if (!magic.starts_with("Slice V0")) return text_.unexpected(magic, "'Slice V0'");
    while (true) {
      const int c = text_.skip_blanks();
      if (c == 'Z' || c == 'E') break;
      const std::string_view line = text_.rest_of_line();
      if (!line.starts_with("FILE(") && !line.starts_with("SLICES(")) {
        return text_.unexpected(line, "'FILE(', 'SLICES(' or 'Z'");
      }
      if (line.find("UNITS(MM") != std::string_view::npos) unit_mm_ = 1;
    }
    return read_faces();
  }

  [[nodiscard]] Result<std::optional<Slice>> next() override {
    if (!faces_) return std::optional<Slice>();
    if (core::Status read = read_contours(); !read.ok()) return read.error();
    Slice slice;
    slice.index = index_++;
    slice.bottom = Length::from_units(faces_->bottom);
    slice.height = Length::from_units(faces_->top - faces_->bottom);
    slice.region = contours_.take(core::FillRule::kEvenOdd);
    if (core::Status read = read_faces(); !read.ok()) return read.error();
    return std::optional<Slice>(std::move(slice));
  }

 private:
  [[nodiscard]] Result<double> real(const std::string& wanted) {
    text_.skip_blanks();
    const std::string_view word = text_.word();
    const std::optional<double> value = parse_real(word);
    if (!value) return text_.unexpected(word, wanted);
    return *value * unit_mm_;
  }

  // REQUIRES: the scanner is at "Z" or "END".
  [[nodiscard]] core::Status read_faces() {
    text_.skip_blanks();
    const std::string_view word = text_.word();
    if (word == "END") {
      faces_.reset();
      return {};
    }
    if (word != "Z") return text_.unexpected(word, "'Z' or 'END'");
    const Result<double> z = real("a layer's height");
    if (!z.ok()) return z.error();
    const Result<double> thickness = real("a layer's thickness");
    if (!thickness.ok()) return thickness.error();
    const std::optional<std::int64_t> bottom = height_units(z.value());
    const std::optional<std::int64_t> top = height_units(z.value() + thickness.value());
    if (!bottom || !top || *top <= *bottom) {
      return text_.bad("a layer without thickness, or out of range; export the file again");
    }
    const auto slack =
        static_cast<std::int64_t>(std::ceil(kSliceV0GapMax * static_cast<double>(*top - *bottom)));
    if (!faces_) {
      faces_ = {*bottom, *top};
      return {};
    }
    if (std::abs(*bottom - faces_->top) > slack || *top <= faces_->top) {
      return text_.bad(
          "the layer begins at " + number_text(z.value()) + " mm, the one below ends at " +
          number_text(Length::from_units(faces_->top).mm()) + " mm; export the file again");
    }
    faces_ = {faces_->top, *top};
    return {};
  }

  [[nodiscard]] core::Status read_contours() {
    bool open = false;
    while (true) {
      const int c = text_.skip_blanks();
      if (c == 'C') {
        static_cast<void>(text_.word());
        if (open) contours_.end();
        open = false;
        continue;
      }
      if (c == 'Z' || c == 'E') {
        if (open) return text_.unexpected(text_.word(), "'C', which closes a contour,");
        return {};
      }
      const Result<double> x = real("a point, 'C', 'Z' or 'END'");
      if (!x.ok()) return x.error();
      const Result<double> y = real("a coordinate");
      if (!y.ok()) return y.error();
      std::string cause = open ? std::string() : contours_.start();
      open = true;
      if (cause.empty()) cause = contours_.add(x.value(), y.value());
      if (!cause.empty()) return text_.bad(cause);
    }
  }

  TextScanner text_;
  double unit_mm_ = kInchMm;
  ContourGatherer contours_;
  std::optional<Faces> faces_;  // of the next layer
  core::LayerIndex index_ = 0;
};

}  // namespace

Result<std::unique_ptr<LayerReader>> open_slice_v0(InputFile file) {
  auto reader = std::make_unique<SliceV0Reader>(std::move(file));
  if (core::Status opened = reader->open(); !opened.ok()) return opened.error();
  return std::unique_ptr<LayerReader>(std::move(reader));
}

}  // namespace host
