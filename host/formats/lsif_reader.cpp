#include "host/formats/lsif_reader.h"

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "core/booleans/boolean.h"       // subtract
#include "core/units.h"                  // Length
#include "host/formats/format_limits.h"  // kNestingMax
#include "host/formats/lsif_sets.h"      // LsifSets
#include "host/formats/sif_scanner.h"    // SifScanner

namespace host {
namespace {

using core::Length;
using core::Result;
using core::Slice;
using core::Status;
using Token = SifScanner::Token;

class LsifReader : public LayerReader {
 public:
  explicit LsifReader(InputFile file) : scanner_(std::move(file)), sets_(scanner_) {}

  [[nodiscard]] std::string format() const override { return "L-SIF"; }

  // Reads up to the first layer's keyword.
  [[nodiscard]] Status open() {
    if (Status opened = scanner_.expect_open(); !opened.ok()) return opened;
    const Result<std::string> magic = scanner_.keyword();
    if (!magic.ok()) return magic.error();
    if (magic.value() != "LSIF") return scanner_.unexpected(Token::kWord, "'LSIF'");
    for (int i = 0; i < 2; ++i) {
      if (const auto version = scanner_.number("a version number"); !version.ok()) {
        return version.error();
      }
    }
    return to_layer();
  }

  [[nodiscard]] Result<std::optional<Slice>> next() override {
    if (ended_) return std::optional<Slice>();
    sets_.start_layer();
    std::optional<std::int64_t> thickness = thickness_;
    while (true) {
      const Result<Token> token = scanner_.next();
      if (!token.ok()) return token.error();
      if (token.value() == Token::kClose) break;
      if (token.value() != Token::kOpen) return scanner_.unexpected(token.value(), "'(' or ')'");
      const Result<std::string> keyword = scanner_.keyword();
      if (!keyword.ok()) return keyword.error();
      if (keyword.value() == "thickness") {
        Result<std::int64_t> own = length("a thickness");
        if (!own.ok()) return own.error();
        thickness = own.value();
      } else if (Status taken = sets_.take_form(keyword.value()); !taken.ok()) {
        return taken.error();
      }
    }
    if (!thickness || *thickness <= 0) {
      return scanner_.bad("layer " + std::to_string(index_ + 1) +
                          " has no thickness, nor has the file; add (thickness …)");
    }
    Slice slice;
    slice.index = index_++;
    slice.bottom = Length::from_units(bottom_);
    slice.height = Length::from_units(*thickness);
    Result<core::Region> region = sets_.finish_layer();
    if (!region.ok()) return region.error();
    slice.region = std::move(region).value();
    bottom_ += *thickness;
    if (sets_.skipped_forms() > 0 && !told_) {
      told_ = true;
      warn(scanner_.name() + ": '" + sets_.first_skipped() + "' was not understood and left out");
    }
    if (Status at = to_layer(); !at.ok()) return at.error();
    return std::optional<Slice>(std::move(slice));
  }

 private:
  // Reads the file's own forms up to the next "(layer", or to its end.
  [[nodiscard]] Status to_layer() {
    while (true) {
      const Result<Token> token = scanner_.next();
      if (!token.ok()) return token.error();
      if (token.value() == Token::kClose) {
        ended_ = true;
        return unit_mm_ ? Status() : scanner_.bad("there are no (units …); add them");
      }
      if (token.value() != Token::kOpen) return scanner_.unexpected(token.value(), "'(' or ')'");
      const Result<std::string> keyword = scanner_.keyword();
      if (!keyword.ok()) return keyword.error();
      if (keyword.value() == "layer") {
        if (unit_mm_) return {};
        return scanner_.bad("a layer before (units …), so that sizes mean nothing; add them");
      }
      if (Status taken = take_head(keyword.value()); !taken.ok()) return taken;
    }
  }

  [[nodiscard]] Status take_head(const std::string& keyword) {
    if (keyword == "units") {
      const Result<std::string> unit = scanner_.keyword();
      if (!unit.ok()) return unit.error();
      const bool mm = unit.value() == "mm";
      if (!mm && unit.value() != "inches" && unit.value() != "inch") {
        return scanner_.unexpected(Token::kWord, "'mm' or 'inches'");
      }
      unit_mm_ = mm ? 1.0 : 25.4;
      sets_.set_unit(*unit_mm_);
      return scanner_.expect_close();
    }
    if (keyword == "thickness") {
      const Result<std::int64_t> all = length("a thickness");
      if (!all.ok()) return all.error();
      thickness_ = all.value();
      return {};
    }
    return scanner_.skip_form();
  }

  // A number and the form's end.
  [[nodiscard]] Result<std::int64_t> length(const std::string& wanted) {
    const Result<double> value = scanner_.number(wanted);
    if (!value.ok()) return value.error();
    if (Status closed = scanner_.expect_close(); !closed.ok()) return closed.error();
    if (!unit_mm_) return scanner_.bad("a length before (units …); put the units first");
    const std::optional<std::int64_t> units = height_units(value.value() * *unit_mm_);
    if (!units || *units < 0) return scanner_.bad(wanted + " is out of range; correct the file");
    return *units;
  }

  SifScanner scanner_;
  LsifSets sets_;
  std::optional<double> unit_mm_;
  std::optional<std::int64_t> thickness_;  // of layers that give none
  std::int64_t bottom_ = 0;
  core::LayerIndex index_ = 0;
  bool ended_ = false;
  bool told_ = false;
};

}  // namespace

Result<std::unique_ptr<LayerReader>> open_lsif(InputFile file) {
  auto reader = std::make_unique<LsifReader>(std::move(file));
  if (Status opened = reader->open(); !opened.ok()) return opened.error();
  return std::unique_ptr<LayerReader>(std::move(reader));
}

}  // namespace host
