#include <bit>
#include <optional>
#include <string>
#include <string_view>

#include "host/formats/cli_geometry.h"
#include "host/formats/format_limits.h"  // kLayerPointsMax
#include "host/formats/little_endian.h"  // u16_at

namespace host {
namespace {

using core::Result;

// Commands; the short ones count in 16 bits.
constexpr unsigned kLayerLong = 127, kLayerShort = 128;
constexpr unsigned kPolylineShort = 129, kPolylineLong = 130;
constexpr unsigned kHatchesShort = 131, kHatchesLong = 132;

class BinaryGeometry : public CliGeometry {
 public:
  BinaryGeometry(TextScanner& bytes, const CliHeader& header)
      : bytes_(bytes), unit_mm_(header.unit_mm), aligned_(header.aligned) {
    // Unsigned by the specification. Writers of parts left of the origin mean signed numbers.
    // Heights stay unsigned: a tall part left of the origin needs all 16 bits for them.
    if (header.dimension_mm) {
      const auto& least = *header.dimension_mm;
      signed_ = least[0] < 0 || least[1] < 0;
      signed_heights_ = least[2] < 0;
    }
  }

  Result<CliCommand> next(ContourGatherer& contours) override {
    if (bytes_.lookahead(1).empty()) {
      if (bytes_.failed()) return bytes_.bad_at_byte("");
      return CliCommand{};
    }
    const std::optional<std::uint32_t> command = short_number();
    if (!command) return cut_short();
    switch (*command) {
      case kLayerLong:
        return layer(long_real());
      case kLayerShort:
        return layer(short_height());
      case kPolylineShort:
      case kPolylineLong:
        return polyline(*command == kPolylineLong, contours);
      case kHatchesShort:
      case kHatchesLong:
        return hatches(*command == kHatchesLong);
      default:
        return bytes_.bad_at_byte("command " + std::to_string(*command) +
                                  " is none of CLI's; the file is damaged, export it again");
    }
  }

  core::Error bad(const std::string& cause) const override { return bytes_.bad_at_byte(cause); }

 private:
  [[nodiscard]] core::Error cut_short() const {
    return bad("the file ends within a command: it is cut short; copy or export it again");
  }

  // A 16-bit item on its own: a command, a count, a height.
  std::optional<std::uint32_t> short_number() {
    const std::size_t size = aligned_ ? 4 : 2;
    const std::string_view bytes = bytes_.lookahead(size);
    if (bytes.size() < size) return std::nullopt;
    const std::uint32_t number = u16_at(bytes.data());
    bytes_.skip(size);
    return number;
  }

  std::optional<double> short_height() {
    const std::optional<std::uint32_t> number = short_number();
    if (!number) return std::nullopt;
    return short_value(static_cast<std::uint16_t>(*number), signed_heights_);
  }

  [[nodiscard]] static double short_value(std::uint16_t number, bool is_signed) {
    return is_signed ? static_cast<double>(std::bit_cast<std::int16_t>(number))
                     : static_cast<double>(number);
  }

  std::optional<double> long_real() {
    const std::string_view bytes = bytes_.lookahead(4);
    if (bytes.size() < 4) return std::nullopt;
    const double number = float_at(bytes.data());
    bytes_.skip(4);
    return number;
  }

  // A label, a direction, a count.
  std::optional<std::int64_t> integer(bool is_long) {
    if (!is_long) return short_number();
    const std::string_view bytes = bytes_.lookahead(4);
    if (bytes.size() < 4) return std::nullopt;
    const auto number = std::bit_cast<std::int32_t>(u32_at(bytes.data()));
    bytes_.skip(4);
    return number;
  }

  Result<CliCommand> layer(std::optional<double> z) const {
    if (!z) return cut_short();
    const std::optional<std::int64_t> units = height_units(*z * unit_mm_);
    if (!units) return bad("a layer's height is out of range; the file is damaged");
    return CliCommand{CliCommand::Kind::kLayer, *units};
  }

  [[nodiscard]] static bool fits(std::int64_t count) {
    return count >= 0 && count <= static_cast<std::int64_t>(kLayerPointsMax);
  }

  Result<CliCommand> polyline(bool is_long, ContourGatherer& contours) {
    const std::optional<std::int64_t> label = integer(is_long), direction = integer(is_long);
    const std::optional<std::int64_t> points = integer(is_long);
    if (!label || !direction || !points) return cut_short();
    if (*direction < kCliClockwise || *direction > kCliOpen || !fits(*points)) {
      return bad("a polyline of direction " + std::to_string(*direction) + " with " +
                 std::to_string(*points) + " points: the file is damaged, export it again");
    }
    std::string cause = contours.start();
    const std::size_t size = is_long ? 8 : 4;
    for (std::int64_t i = 0; i < *points && cause.empty(); ++i) {
      const std::string_view pair = bytes_.lookahead(size);
      if (pair.size() < size) return cut_short();
      const char* at = pair.data();
      const double x = is_long ? float_at(at) : short_value(u16_at(at), signed_);
      const double y = is_long ? float_at(at + 4) : short_value(u16_at(at + 2), signed_);
      cause = contours.add(x * unit_mm_, y * unit_mm_);
      if (cause.empty()) bytes_.skip(size);
    }
    if (!cause.empty()) return bad(cause);
    if (*direction == kCliOpen) {
      contours.drop();
      return CliCommand{CliCommand::Kind::kOpen};
    }
    contours.end(cli_turn(*direction));
    return CliCommand{CliCommand::Kind::kContour};
  }

  Result<CliCommand> hatches(bool is_long) {
    const std::optional<std::int64_t> label = integer(is_long), lines = integer(is_long);
    if (!label || !lines) return cut_short();
    if (!fits(*lines)) {
      return bad(std::to_string(*lines) + " hatches: the file is damaged, export it again");
    }
    const std::size_t size = is_long ? 16 : 8;
    for (std::int64_t i = 0; i < *lines; ++i) {
      if (bytes_.lookahead(size).size() < size) return cut_short();
      bytes_.skip(size);
    }
    return CliCommand{CliCommand::Kind::kHatches};
  }

  TextScanner& bytes_;
  double unit_mm_;
  bool aligned_;
  bool signed_ = false;  // coordinates of 16 bits
  bool signed_heights_ = false;
};

}  // namespace

std::unique_ptr<CliGeometry> cli_binary_geometry(TextScanner& text, const CliHeader& header) {
  return std::make_unique<BinaryGeometry>(text, header);
}

}  // namespace host
