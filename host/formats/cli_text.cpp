#include <optional>
#include <string>
#include <string_view>

#include "host/formats/cli_geometry.h"
#include "host/formats/format_limits.h"  // kLayerPointsMax
#include "host/formats/number_text.h"    // parse_real

namespace host {
namespace {

using core::Result;
using core::Status;

class TextGeometry : public CliGeometry {
 public:
  TextGeometry(TextScanner& text, double unit_mm) : text_(text), unit_mm_(unit_mm) {}

  Result<CliCommand> next(ContourGatherer& contours) override {
    while (true) {
      if (Status at = to_command(); !at.ok()) return at.error();
      const std::string_view name = text_.word("/$,");
      if (name == "GEOMETRYEND") return CliCommand{};
      if (name == "LAYER") return layer();
      if (name == "POLYLINE") return polyline(contours);
      if (name == "HATCHES") return hatches();
    }
  }

  core::Error bad(const std::string& cause) const override { return text_.bad(cause); }

 private:
  // Skips to behind the next "$$": the text before it belongs to an ignored command.
  Status to_command() {
    int dollars = 0;
    while (dollars < 2) {
      const int c = skip_gap();
      if (c == TextScanner::kEnd) return text_.cut_short("'$$GEOMETRYEND'");
      dollars = c == '$' ? dollars + 1 : 0;
      text_.take();
    }
    return {};
  }

  // Skips blanks and comments. Returns peek().
  int skip_gap() {
    while (true) {
      const int c = text_.skip_blanks();
      if (c != '/' || text_.lookahead(2) != "//") return c;
      text_.take();
      text_.take();
      while (text_.peek() != TextScanner::kEnd && text_.lookahead(2) != "//") text_.take();
      if (text_.peek() == TextScanner::kEnd) return TextScanner::kEnd;
      text_.take();
      text_.take();
    }
  }

  // The next parameter. A "/" is before the first one, commas are between the others.
  std::string_view parameter() {
    const int c = skip_gap();
    if (c == '/' || c == ',') {
      text_.take();
      skip_gap();
    }
    return text_.word(",$/");
  }

  Result<double> real(const std::string& wanted) {
    const std::string_view word = parameter();
    const std::optional<double> value = parse_real(word);
    if (!value) return text_.unexpected(word, wanted);
    return *value;
  }

  Result<std::int64_t> integer(const std::string& wanted) {
    const std::string_view word = parameter();
    const std::optional<std::int64_t> value = parse_integer(word);
    if (!value) return text_.unexpected(word, wanted);
    return *value;
  }

  Result<CliCommand> layer() {
    const Result<double> z = real("a layer's height");
    if (!z.ok()) return z.error();
    const std::optional<std::int64_t> units = height_units(z.value() * unit_mm_);
    if (!units) return text_.bad("a layer's height is out of range; check the file's unit");
    return CliCommand{CliCommand::Kind::kLayer, *units};
  }

  Result<std::int64_t> count(const std::string& wanted) {
    Result<std::int64_t> n = integer("the number of " + wanted);
    if (!n.ok()) return n;
    if (n.value() < 0 || n.value() > static_cast<std::int64_t>(kLayerPointsMax)) {
      return text_.bad(std::to_string(n.value()) + " is no number of " + wanted +
                       " that fits; export the file again");
    }
    return n;
  }

  Result<CliCommand> polyline(ContourGatherer& contours) {
    const Result<std::int64_t> label = integer("a label");
    if (!label.ok()) return label.error();
    const Result<std::int64_t> direction = integer("a polyline's direction");
    if (!direction.ok()) return direction.error();
    if (direction.value() < kCliClockwise || direction.value() > kCliOpen) {
      return text_.bad("a polyline's direction is " + std::to_string(direction.value()) +
                       ", not 0, 1 or 2; export the file again");
    }
    const Result<std::int64_t> points = count("points");
    if (!points.ok()) return points.error();
    std::string cause = contours.start();
    for (std::int64_t i = 0; i < points.value() && cause.empty(); ++i) {
      const Result<double> x = real("a coordinate");
      if (!x.ok()) return x.error();
      const Result<double> y = real("a coordinate");
      if (!y.ok()) return y.error();
      cause = contours.add(x.value() * unit_mm_, y.value() * unit_mm_);
    }
    if (!cause.empty()) return text_.bad(cause);
    if (direction.value() == kCliOpen) {
      contours.drop();
      return CliCommand{CliCommand::Kind::kOpen};
    }
    contours.end(cli_turn(direction.value()));
    return CliCommand{CliCommand::Kind::kContour};
  }

  Result<CliCommand> hatches() {
    const Result<std::int64_t> label = integer("a label");
    if (!label.ok()) return label.error();
    const Result<std::int64_t> lines = count("hatches");
    if (!lines.ok()) return lines.error();
    for (std::int64_t i = 0; i < 4 * lines.value(); ++i) {
      if (const Result<double> number = real("a coordinate"); !number.ok()) return number.error();
    }
    return CliCommand{CliCommand::Kind::kHatches};
  }

  TextScanner& text_;
  double unit_mm_;
};

}  // namespace

std::unique_ptr<CliGeometry> cli_text_geometry(TextScanner& text, const CliHeader& header) {
  return std::make_unique<TextGeometry>(text, header.unit_mm);
}

}  // namespace host
