#include "host/part/transform_words.h"

#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "host/system/text.h"  // trimmed

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

Error bad(std::string_view setting, std::string_view text, const std::string& expected) {
  return {ErrorCode::kBadSetting,
          std::string(setting) + " = " + std::string(text) + ": expected " + expected};
}

// A number that the end may follow.
std::optional<double> number(std::string_view text, std::string_view end = {}) {
  text = trimmed(text);
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  text = trimmed(text);
  if (text.empty() || (!end.empty() && text == end)) return value;
  return std::nullopt;
}

std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t comma = text.find(',');
    parts.push_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

std::optional<double> factor(std::string_view text) {
  if (const auto plain = number(text)) return plain;
  const auto percent = number(text, "%");
  return percent ? std::optional(*percent / 100) : std::nullopt;
}

}  // namespace

Result<ScaleWords> read_scale(std::string_view text) {
  const std::string expected =
      "a factor from 0.0001 to 10000 as 2 or 150%, three of them as 1,1,2, or a longest side as "
      "to 100mm";
  ScaleWords words;
  if (trimmed(text).substr(0, 3) == "to ") {
    words.longest_mm = number(trimmed(text).substr(3), "mm");
    if (words.longest_mm && *words.longest_mm > 0 && *words.longest_mm < 1e6) return words;
    return bad("part_scale", text, expected);
  }
  const std::vector<std::string_view> parts = parts_of(text);
  if (parts.size() != 1 && parts.size() != 3) return bad("part_scale", text, expected);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::optional<double> read = factor(parts[i]);
    if (!read || *read < kScaleMin || *read > kScaleMax) return bad("part_scale", text, expected);
    if (parts.size() == 1) words.factors.fill(*read);
    words.factors[i] = *read;
  }
  return words;
}

Result<std::array<double, 3>> read_rotation(std::string_view text) {
  std::array<double, 3> degrees{};
  const std::vector<std::string_view> parts = parts_of(text);
  const auto is_wrong = [](const std::optional<double>& read) {
    return !read || std::abs(*read) > 3'600;
  };
  for (std::size_t i = 0; i < parts.size() && parts.size() <= 3; ++i) {
    const std::optional<double> read = number(parts[i]);
    if (is_wrong(read)) break;
    degrees[parts.size() == 1 ? 2 : i] = *read;
    if (i + 1 == parts.size() && i != 1) return degrees;
  }
  return bad("part_rotation", text, "degrees about x, y, z as 90,0,45, or about z as 45");
}

Result<std::optional<CutWords>> read_cut(std::string_view text) {
  std::string_view height = trimmed(text);
  if (height.empty() || height == "off") return std::optional<CutWords>();
  CutWords words;
  const std::size_t space = height.find_last_of(" \t");
  const std::string_view last = space == std::string_view::npos ? "" : height.substr(space + 1);
  if (last == "lower" || last == "upper" || last == "both") {
    if (last == "lower") words.piece = CutPiece::kLower;
    if (last == "upper") words.piece = CutPiece::kUpper;
    height = height.substr(0, space);
  }
  const std::optional<double> read = number(height, "mm");
  if (!read || *read <= 0 || *read > kCutMax_mm) {
    return bad("cut", text,
               "a height in mm above the part's lowest point, as 20, '20 lower' or "
               "'20 upper'; or off");
  }
  words.height_mm = *read;
  return std::optional<CutWords>(words);
}

}  // namespace host
