#include "core/slices/height_ranges.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <utility>

#include "core/decimal_text.h"          // read_decimal, take_word
#include "core/limits.h"                // kHeightRangesMax
#include "core/slices/height_limits.h"  // adaptive_bounds

namespace core {
namespace {

constexpr const char* kExpected = R"(expected "FROM-TO HEIGHT" in mm, as "10-12.5 0.1")";

constexpr int kDecimals = 4;  // units
constexpr std::int64_t kUnitsMax = std::int64_t{1'000'000} * std::int64_t{10'000};
// As layer_height may be.
constexpr Length kLowest = Length::from_units(100), kHighest = Length::from_units(20'000);

Error bad(std::string message) { return {ErrorCode::kBadSetting, std::move(message)}; }

std::optional<Length> read_length(std::string_view text) {
  const std::optional<std::int64_t> units = read_decimal(text, kDecimals, kUnitsMax);
  if (!units) return std::nullopt;
  return Length::from_units(*units);
}

// "12.5 mm"
std::string mm(Length length) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), length.mm());
  return std::string(text.data(), end.ptr) + " mm";
}

std::string name(const HeightRange& range) {
  return "height_range, line " + std::to_string(range.line);
}

// The space between `below`, which is called `what`, and the range above it.
Status check_space(Length below, const std::string& what, const HeightRange& range,
                   const Settings& settings) {
  const Length least = least_between_ranges(settings);
  if (range.from == below || (range.from - below) * 2 >= least) return {};
  return bad(name(range) + ": it begins at " + mm(range.from) + ", " + mm(range.from - below) +
             " above " + what + ", which ends at " + mm(below) +
             ": too little for a layer; begin at " + mm(below) + ", or at " +
             mm(below + Length::from_units((least.units() + 1) / 2)) + " or above");
}

}  // namespace

Length first_layer_height(const Settings& settings) {
  const Length first = settings.first_layer_height;
  return first > Length() ? first : settings.layer_height;
}

Length least_between_ranges(const Settings& settings) {
  return settings.adaptive_layer_height ? adaptive_bounds(settings).lowest : settings.layer_height;
}

Result<HeightRange> read_height_range(std::string_view text) {
  const Error unknown = bad("\"" + std::string(text) + "\" is not understood: " + kExpected);
  const std::size_t dash = text.find('-');
  if (dash == std::string_view::npos) return unknown;
  std::string_view rest = text.substr(dash + 1);
  const std::optional<Length> from = read_length(without_blanks(text.substr(0, dash)));
  const std::optional<Length> to = read_length(take_word(rest));
  const std::optional<Length> height = read_length(take_word(rest));
  if (!from || !to || !height || !rest.empty()) return unknown;
  if (*to <= *from) return bad("it ends at " + mm(*to) + ", not above " + mm(*from));
  if (*height < kLowest || *height > kHighest) {
    return bad("layers of " + mm(*height) + ": expected 0.01 to 2 mm");
  }
  return HeightRange{*from, *to, *height};
}

Result<std::vector<HeightRange>> height_ranges(const Settings& settings) {
  std::vector<HeightRange> ranges;
  if (settings.height_range.size() > kHeightRangesMax) {
    return bad("height_range: more than " + std::to_string(kHeightRangesMax) + " lines");
  }
  for (std::size_t i = 0; i < settings.height_range.size(); ++i) {
    Result<HeightRange> range = read_height_range(settings.height_range[i]);
    if (!range.ok()) {
      return bad("height_range, line " + std::to_string(i + 1) + ": " + range.error().message);
    }
    range.value().line = i + 1;
    ranges.push_back(range.value());
  }
  std::stable_sort(ranges.begin(), ranges.end(),
                   [](const HeightRange& a, const HeightRange& b) { return a.from < b.from; });
  Length below = first_layer_height(settings);
  std::string what = "the first layer";
  for (HeightRange& range : ranges) {
    if (range.to <= below && &range == &ranges.front()) {
      return bad(name(range) + ": it ends at " + mm(range.to) + ", within the first layer of " +
                 mm(below) + ", which keeps its height");
    }
    if (&range == &ranges.front()) {
      range.from = std::max(range.from, below);
    } else if (range.from < below) {
      return bad(name(range) + ": it begins at " + mm(range.from) + ", within " + what +
                 ", whose layers end at " + mm(below));
    }
    if (Status fits = check_space(below, what, range, settings); !fits.ok()) return fits.error();
    below = range.end();
    what = "line " + std::to_string(range.line);
  }
  return ranges;
}

}  // namespace core
