#include "host/part/modifier_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "host/formats/text_scanner.h"  // shown
#include "host/part/pattern_words.h"    // kPatternWords
#include "host/system/text.h"           // trimmed

namespace host {
namespace {

// "40%" and "40" are the same in both slicers.
std::optional<double> density_in(std::string_view text) {
  text = trimmed(text);
  if (text.ends_with('%')) text = trimmed(text.substr(0, text.size() - 1));
  double percent = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), percent);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (!(percent >= 0 && percent <= 100)) return std::nullopt;
  return percent / 100;
}

const PatternWord* pattern_in(std::string_view text) {
  const auto* found = std::find_if(kPatternWords.begin(), kPatternWords.end(),
                                   [&](const PatternWord& one) { return one.theirs == text; });
  const bool usable =
      found != kPatternWords.end() && found->pattern != core::LoosePattern::kLightning;
  return usable ? found : nullptr;
}

void add(std::string_view text, std::string& list) {
  if (!list.empty()) list += ", ";
  list += text;
}

bool has_loose_roads(const core::Settings& settings) {
  return settings.loose_pattern != core::LoosePattern::kLightning && !settings.spiral_vase &&
         settings.style != core::BuildStyle::kRegular;
}

}  // namespace

ModifierWords read_modifier(const ModifierSettings& modifier, const core::Settings& settings) {
  ModifierWords words;
  const bool possible = has_loose_roads(settings);
  for (const auto& [key, value] : modifier) {
    if (possible && (key == "fill_density" || key == "sparse_infill_density")) {
      words.change.density = density_in(value);
      if (words.change.density) {
        add(fmt::format("density {:g} %", *words.change.density * 100), words.used);
        continue;
      }
    } else if (possible && (key == "fill_pattern" || key == "sparse_infill_pattern")) {
      const PatternWord* pattern = pattern_in(value);
      if (pattern != nullptr) {
        words.change.pattern = pattern->pattern;
        add(fmt::format("pattern {}", pattern->ours), words.used);
        continue;
      }
    }
    add(shown(key) + " = " + shown(value), words.unused);
  }
  return words;
}

}  // namespace host
