#include "host/presets/presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/presets/headed_profile.h"

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

constexpr std::array<std::string_view, 3> kKeys = {"title", "machine_type", "measured"};

}  // namespace

std::string_view preset_kind_word(PresetKind kind) {
  constexpr std::array<std::string_view, 3> kWords = {"printer", "filament", "quality"};
  return kWords[static_cast<std::size_t>(kind)];
}

Result<Preset> find_preset(PresetKind kind, std::string_view name) {
  std::string known;
  for (const PresetText& one : preset_texts()) {
    if (one.kind != kind) continue;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", one.name);
    if (one.name != name) continue;
    const std::string file = fmt::format("preset {}", name);
    Result<HeadedProfile> read = read_headed_profile(one.text, file, "preset", kKeys);
    if (!read.ok()) return read.error();
    HeadedProfile& profile = read.value();
    return Preset{std::string(name), std::string(profile.value("title")),
                  std::string(profile.value("machine_type")), profile.value("measured") != "no",
                  std::move(profile.settings)};
  }
  return Error{ErrorCode::kBadSetting, fmt::format("there is no {} preset \"{}\"; there are {}",
                                                   preset_kind_word(kind), name, known)};
}

}  // namespace host
