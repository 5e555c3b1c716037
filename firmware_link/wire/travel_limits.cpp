#include "firmware_link/wire/travel_limits.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace firmware_link {
namespace {

constexpr std::string_view kAxes = "xyz";

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// "X1.5 Y2 Z3" or "{x:1.5,y:2,z:3": blanks, colons, commas and braces stand between.
std::optional<std::array<double, 3>> position_in(std::string_view text) {
  std::array<double, 3> position{};
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const auto skip = [&text](std::string_view what) {
      text.remove_prefix(std::min(text.find_first_not_of(what), text.size()));
    };
    skip(" ,{");
    if (text.empty() || lower(text.front()) != kAxes[axis]) return std::nullopt;
    text.remove_prefix(1);
    skip(" :");
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), position[axis]);
    if (error != std::errc{} || !std::isfinite(position[axis])) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  return position;
}

std::optional<TravelLimits> between(std::string_view line, std::string_view min,
                                    std::string_view max) {
  const std::size_t low = line.find(min);
  if (low == std::string_view::npos) return std::nullopt;
  const std::size_t high = line.find(max, low + min.size());
  if (high == std::string_view::npos) return std::nullopt;
  const auto lowest = position_in(line.substr(low + min.size()));
  const auto highest = position_in(line.substr(high + max.size()));
  if (!lowest || !highest) return std::nullopt;
  TravelLimits limits{*lowest, *highest};
  for (std::size_t axis = 0; axis < limits.min_mm.size(); ++axis) {
    if (limits.max_mm[axis] <= limits.min_mm[axis]) return std::nullopt;
  }
  return limits;
}

}  // namespace

std::optional<TravelLimits> travel_limits_in(std::string_view line) {
  if (line.find("area:{full:") != std::string_view::npos) return between(line, "min:", "max:");
  return between(line, "Min:", "Max:");
}

}  // namespace firmware_link
