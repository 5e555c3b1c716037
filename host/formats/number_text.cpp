#include "host/formats/number_text.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>

#include "core/units.h"  // kUnitsPerMm

namespace host {
static_assert(core::kUnitsPerMm == 10'000.0, "four decimals of a millimetre are a unit");

std::optional<double> parse_real(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || text.starts_with('+')) return std::nullopt;
  double value = 0;
  const auto [end, error] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || end != text.data() + text.size()) return std::nullopt;
  return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

void append_mm(std::int64_t units, std::string& into) {
  char digits[24];
  const std::uint64_t size =
      units < 0 ? 0 - static_cast<std::uint64_t>(units) : static_cast<std::uint64_t>(units);
  constexpr std::uint64_t kPerMm = 10'000;
  if (units < 0) into += '-';
  into.append(digits, std::to_chars(digits, digits + sizeof digits, size / kPerMm).ptr);
  std::uint64_t rest = size % kPerMm;
  if (rest == 0) return;
  into += '.';
  for (std::uint64_t place = kPerMm / 10; rest > 0; rest %= place, place /= 10) {
    into += static_cast<char>('0' + rest / place);
    if (place == 1) break;
  }
}

void append_real_mm(std::int64_t units, std::string& into) {
  append_mm(units, into);
  if (units % 10'000 == 0) into += ".0";
}

void append_inches(std::int64_t units, std::string& into) {
  const double inches = static_cast<double>(units) / (25.4 * core::kUnitsPerMm);
  fmt::format_to(std::back_inserter(into), "{:.8f}", inches);
  into.erase(into.find_last_not_of('0') + 1);
  if (into.ends_with('.')) into += '0';
}

std::string number_text(double value) { return fmt::format("{:g}", value); }

}  // namespace host
