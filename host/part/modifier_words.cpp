#include "host/part/modifier_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "host/formats/text_scanner.h"  // shown
#include "host/part/modifier_values.h"  // read_laid_value
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

// Branches, the insides that are laid for several layers at once and the fast style are planned by
// the part's own number; with none at all, the wall is filled up to the contour.
bool may_count_perimeters(const core::Settings& settings) {
  return settings.perimeters > 0 && !settings.spiral_vase &&
         settings.style != core::BuildStyle::kFast && settings.loose_every_layers == 1 &&
         settings.loose_pattern != core::LoosePattern::kLightning;
}

std::optional<int> perimeters_in(std::string_view text) {
  text = trimmed(text);
  int count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (count < 1 || count > kAreaPerimetersMax) return std::nullopt;
  return count;
}

class Reading {
 public:
  Reading(const ModifierSettings& modifier, const core::Settings& settings)
      : modifier_(modifier), settings_(settings), inside_(has_loose_roads(settings)) {}

  [[nodiscard]] ModifierWords read() {
    for (const auto& [key, value] : modifier_) {
      if (!use(key, value)) add(shown(key) + " = " + shown(value), words_.unused);
    }
    complete_laid_values(settings_, words_.change);
    return std::move(words_);
  }

 private:
  // False where it can't be used.
  bool use(const std::string& key, const std::string& value) {
    if (key == "fill_density" || key == "sparse_infill_density") return use_density(value);
    if (key == "fill_pattern" || key == "sparse_infill_pattern") return use_pattern(value);
    if (key == "perimeters" || key == "wall_loops") return use_perimeters(value);
    if (settings_.spiral_vase) return false;
    std::string words;
    const ValueUse used = read_laid_value(key, modifier_, settings_, words_.change, words);
    if (used == ValueUse::kUsed) add(words, words_.used);
    return used != ValueUse::kNone;
  }

  bool use_density(const std::string& value) {
    const std::optional<double> density = inside_ ? density_in(value) : std::nullopt;
    if (!density) return false;
    words_.change.density = density;
    add(fmt::format("density {:g} %", *density * 100), words_.used);
    return true;
  }

  bool use_pattern(const std::string& value) {
    const PatternWord* pattern = inside_ ? pattern_in(value) : nullptr;
    if (pattern == nullptr) return false;
    words_.change.pattern = pattern->pattern;
    add(fmt::format("pattern {}", pattern->ours), words_.used);
    return true;
  }

  bool use_perimeters(const std::string& value) {
    const std::optional<int> count =
        may_count_perimeters(settings_) ? perimeters_in(value) : std::nullopt;
    if (!count) return false;
    words_.change.perimeters = count;
    add(fmt::format("{} perimeter{}", *count, *count == 1 ? "" : "s"), words_.used);
    return true;
  }

  const ModifierSettings& modifier_;
  const core::Settings& settings_;
  bool inside_;
  ModifierWords words_;
};

template <typename Value>
bool is_own(const std::vector<ModifierWords>& all, const Value& value_of) {
  return std::all_of(all.begin(), all.end(), [&](const ModifierWords& words) {
    const auto [said, own] = value_of(words.change);
    return !said || *said == own;
  });
}

}  // namespace

ModifierWords read_modifier(const ModifierSettings& modifier, const core::Settings& settings) {
  return Reading(modifier, settings).read();
}

void leave_out_own(const core::Settings& settings, std::vector<ModifierWords>& all) {
  const core::LaidValues own = own_laid_values(settings);
  const bool density = is_own(all, [&](const core::AreaChange& change) {
    return std::pair(change.density, settings.loose_density);
  });
  const bool pattern = is_own(all, [&](const core::AreaChange& change) {
    return std::pair(change.pattern, settings.loose_pattern);
  });
  const bool perimeters = is_own(all, [&](const core::AreaChange& change) {
    return std::pair(change.perimeters, settings.perimeters);
  });
  for (ModifierWords& words : all) {
    if (density) words.change.density.reset();
    if (pattern) words.change.pattern.reset();
    if (perimeters) words.change.perimeters.reset();
  }
  for (std::size_t i = 0; i < own.size(); ++i) {
    const bool same = is_own(
        all, [&](const core::AreaChange& change) { return std::pair(change.laid[i], *own[i]); });
    if (!same) continue;
    for (ModifierWords& words : all) words.change.laid[i].reset();
  }
}

}  // namespace host
