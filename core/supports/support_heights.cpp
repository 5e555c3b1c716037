#include "core/supports/support_heights.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "core/decimal_text.h"  // read_decimal, take_word, without_blanks
#include "core/limits.h"        // kHeightRangesMax

namespace core {
namespace {

constexpr const char* kExpected = R"(expected "FROM-TO on" or "FROM-TO off" in mm, as "0-20 off")";

constexpr int kDecimals = 4;  // units
constexpr std::int64_t kUnitsMax = std::int64_t{1'000'000} * std::int64_t{10'000};

Error bad(std::string message) { return {ErrorCode::kBadSetting, std::move(message)}; }

}  // namespace

Result<SupportRange> read_support_range(std::string_view text) {
  const Error unknown = bad("\"" + std::string(text) + "\" is not understood: " + kExpected);
  const std::size_t dash = text.find('-');
  if (dash == std::string_view::npos) return unknown;
  std::string_view rest = text.substr(dash + 1);
  const auto from = read_decimal(without_blanks(text.substr(0, dash)), kDecimals, kUnitsMax);
  const auto to = read_decimal(take_word(rest), kDecimals, kUnitsMax);
  const std::string_view word = take_word(rest);
  if (!from || !to || (word != "on" && word != "off") || !rest.empty()) return unknown;
  if (*to <= *from) {
    return bad("\"" + std::string(text) + "\" ends below where it begins: " + kExpected);
  }
  return SupportRange{Length::from_units(*from), Length::from_units(*to), word == "on"};
}

Result<std::vector<SupportRange>> support_ranges(const Settings& settings) {
  std::vector<SupportRange> ranges;
  if (settings.support_height_range.size() > kHeightRangesMax) {
    return bad("support_height_range: more than " + std::to_string(kHeightRangesMax) + " lines");
  }
  for (std::size_t i = 0; i < settings.support_height_range.size(); ++i) {
    Result<SupportRange> range = read_support_range(settings.support_height_range[i]);
    if (!range.ok()) {
      return bad("support_height_range, line " + std::to_string(i + 1) + ": " +
                 range.error().message);
    }
    range.value().line = i + 1;
    ranges.push_back(range.value());
  }
  std::stable_sort(ranges.begin(), ranges.end(),
                   [](const SupportRange& a, const SupportRange& b) { return a.from < b.from; });
  for (std::size_t i = 1; i < ranges.size(); ++i) {
    if (ranges[i].from >= ranges[i - 1].to) continue;
    const std::size_t first = std::min(ranges[i - 1].line, ranges[i].line);
    const std::size_t second = std::max(ranges[i - 1].line, ranges[i].line);
    return bad("support_height_range: lines " + std::to_string(first) + " and " +
               std::to_string(second) + " overlap; say on or off once for each height");
  }
  return ranges;
}

SupportHeights::SupportHeights(const Settings& settings)
    : elsewhere_(settings.support_auto), ranges_(support_ranges(settings).value()) {}

bool SupportHeights::hold_at(Length bottom) const {
  const auto after =
      std::upper_bound(ranges_.begin(), ranges_.end(), bottom,
                       [](Length at, const SupportRange& range) { return at < range.from; });
  if (after == ranges_.begin() || bottom >= std::prev(after)->to) return elsewhere_;
  return std::prev(after)->on;
}

bool SupportHeights::hold_anywhere() const {
  return elsewhere_ || std::any_of(ranges_.begin(), ranges_.end(),
                                   [](const SupportRange& range) { return range.on; });
}

}  // namespace core
