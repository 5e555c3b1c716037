#include "host/formats/slc_reader.h"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/units.h"                     // Length
#include "host/formats/contour_gatherer.h"  // ContourGatherer
#include "host/formats/format_limits.h"     // kLayerPointsMax
#include "host/formats/little_endian.h"     // u32_at
#include "host/formats/text_scanner.h"      // TextScanner, is_blank, shown

namespace host {
namespace {

using core::Length;
using core::Result;
using core::Slice;

constexpr std::size_t kHeadBytesPadded = 2'048;
constexpr std::size_t kReservedBytes = 256;
constexpr std::size_t kTableRowBytes = 16;
constexpr char kHeadEnd = 0x1A;
constexpr std::uint32_t kLastLayer = 0xFFFF'FFFF;

// The word behind a key, up to a blank or the next key: some writers put no blank between them.
// Empty if there is none.
std::string_view value_of(std::string_view head, std::string_view key) {
  const auto blank = [](char c) { return is_blank(static_cast<unsigned char>(c)); };
  std::size_t at = head.find(key);
  if (at == std::string_view::npos) return {};
  at += key.size();
  while (at < head.size() && blank(head[at])) ++at;
  std::size_t end = at;
  while (end < head.size() && !blank(head[end]) && head[end] != '-') ++end;
  return head.substr(at, end - at);
}

class SlcReader : public LayerReader {
 public:
  explicit SlcReader(InputFile file) : bytes_(std::move(file)) {}

  [[nodiscard]] std::string format() const override { return "SLC"; }

  [[nodiscard]] core::Status open() {
    const std::string_view start = bytes_.lookahead(kHeadBytesPadded);
    const std::size_t end = start.find(kHeadEnd);
    if (end == std::string_view::npos) {
      return bytes_.bad_at_byte("no end of the SLC head in its " +
                                std::to_string(kHeadBytesPadded) +
                                " bytes; the file is damaged, export it again");
    }
    const std::string_view head = start.substr(0, end);
    const bool plural = head.find("-UNITS") != std::string_view::npos;
    const std::string_view unit = value_of(head, plural ? "-UNITS" : "-UNIT");
    const bool inches = unit == "INCH";
    if (!inches && unit != "MM") {
      return bytes_.bad_at_byte("the head names no unit, MM or INCH; export the file again");
    }
    unit_mm_ = inches ? 25.4 : 1.0;
    const std::string_view type = value_of(head, "-TYPE");
    if (!type.empty() && type != "PART") {
      warn(bytes_.name() + ": its head says that it holds no part but a " + shown(type) +
           "; it is printed like a part");
    }
    // Uses the offset that has a table behind it.
    const std::size_t close = end + 1;
    const bool padded = !table_at(close) && table_at(kHeadBytesPadded);
    bytes_.skip(
        std::min(bytes_.lookahead(kHeadBytesPadded).size(), padded ? kHeadBytesPadded : close));
    const std::size_t rest = kReservedBytes + 1;
    const std::string_view table = bytes_.lookahead(rest);
    if (table.size() < rest) return cut_short();
    const std::size_t rows = static_cast<unsigned char>(table[kReservedBytes]);
    const std::size_t bytes = rest + rows * kTableRowBytes;
    if (bytes_.lookahead(bytes).size() < bytes) return cut_short();
    bytes_.skip(bytes);
    return start_layer();
  }

  [[nodiscard]] Result<std::optional<Slice>> next() override {
    if (!boundaries_) return std::optional<Slice>();
    for (std::uint32_t i = 0; i < *boundaries_; ++i) {
      if (core::Status read = boundary(); !read.ok()) return read.error();
    }
    const std::int64_t bottom = z_;
    if (core::Status started = start_layer(); !started.ok()) return started.error();
    if (z_ <= bottom) {
      return bytes_.bad_at_byte("layer " + std::to_string(index_ + 2) +
                                " does not lie above the one before; export the file again");
    }
    Slice slice;
    slice.index = index_++;
    slice.bottom = Length::from_units(bottom);
    slice.height = Length::from_units(z_ - bottom);
    slice.region = contours_.take(core::FillRule::kNonZero);
    return std::optional<Slice>(std::move(slice));
  }

 private:
  [[nodiscard]] core::Error cut_short() const {
    return bytes_.bad_at_byte(
        "the file ends before its last layer: it is cut short; copy or "
        "export it again");
  }

  // True if reserved bytes and a plausible table follow.
  bool table_at(std::size_t at) {
    const std::size_t rows_at = at + kReservedBytes;
    const std::string_view bytes = bytes_.lookahead(rows_at + 1 + 255 * kTableRowBytes);
    if (bytes.size() <= rows_at) return false;
    const std::size_t rows = static_cast<unsigned char>(bytes[rows_at]);
    if (rows == 0 || bytes.size() < rows_at + 1 + rows * kTableRowBytes) return false;
    for (std::size_t row = 0; row < rows; ++row) {
      const char* entry = bytes.data() + rows_at + 1 + row * kTableRowBytes;
      const double z = float_at(entry), thickness = float_at(entry + 4);
      // Zeros are no thickness, nor is padding: blanks read as a float of 1e-19.
      if (!std::isfinite(z) || !(thickness > 1e-6 && thickness < 1e6)) return false;
    }
    return true;
  }

  // Reads height and count of the next layer. No count: the end; the height is the last layer's
  // top.
  [[nodiscard]] core::Status start_layer() {
    const std::string_view bytes = bytes_.lookahead(8);
    if (bytes.size() < 8) return cut_short();
    const std::optional<std::int64_t> z = height_units(float_at(bytes.data()) * unit_mm_);
    if (!z) return bytes_.bad_at_byte("a layer's height is out of range; the file is damaged");
    z_ = *z;
    boundaries_ = u32_at(bytes.data() + 4);
    bytes_.skip(8);
    if (*boundaries_ == kLastLayer) {
      boundaries_.reset();
    } else if (*boundaries_ > kLayerRingsMax) {
      return bytes_.bad_at_byte("a layer of " + std::to_string(*boundaries_) +
                                " boundaries, more than fit; the file is damaged");
    }
    return {};
  }

  [[nodiscard]] core::Status boundary() {
    const std::string_view head = bytes_.lookahead(8);
    if (head.size() < 8) return cut_short();
    const std::uint32_t points = u32_at(head.data());
    if (points > kLayerPointsMax) {
      return bytes_.bad_at_byte("a boundary of " + std::to_string(points) +
                                " points, more than fit; the file is damaged");
    }
    if (u32_at(head.data() + 4) != 0 && gaps_++ == 0) {
      warn(bytes_.name() + ": boundaries with gaps were closed");
    }
    bytes_.skip(8);
    std::string cause = contours_.start();
    for (std::uint32_t i = 0; i < points && cause.empty(); ++i) {
      const std::string_view pair = bytes_.lookahead(8);
      if (pair.size() < 8) return cut_short();
      cause = contours_.add(float_at(pair.data()) * unit_mm_, float_at(pair.data() + 4) * unit_mm_);
      if (cause.empty()) bytes_.skip(8);
    }
    if (!cause.empty()) return bytes_.bad_at_byte(cause);
    contours_.end();
    return {};
  }

  TextScanner bytes_;
  double unit_mm_ = 1;
  ContourGatherer contours_;
  std::int64_t z_ = 0;
  std::optional<std::uint32_t> boundaries_;  // of the next layer
  core::LayerIndex index_ = 0;
  std::int64_t gaps_ = 0;
};

}  // namespace

Result<std::unique_ptr<LayerReader>> open_slc(InputFile file) {
  auto reader = std::make_unique<SlcReader>(std::move(file));
  if (core::Status opened = reader->open(); !opened.ok()) return opened.error();
  return std::unique_ptr<LayerReader>(std::move(reader));
}

}  // namespace host
