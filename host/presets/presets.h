// Settings that come with the program: printers, filaments, and qualities of a print. Each is a
// file in printers/, filaments/ or qualities/, and part of the program, so that it needs no other
// file.
//
//     [preset]
//     title = Creality Ender 3
//     machine_type = Ender-3     printers: words of the controller's own name (M115)
//     measured = no              printers: it is for machines of any size, and people are asked
//     [rind]
//     bed_x = 220                settings, as in every profile
//
// Values come from public data sheets and configurations; G-code is our own.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/result.h"  // Result

namespace host {

enum class PresetKind { kPrinter, kFilament, kQuality };

// As it was built into the program.
struct PresetText {
  PresetKind kind;
  std::string_view name;  // of its file, without ".ini"
  std::string_view text;
};

struct Preset {
  std::string name;
  std::string title;
  std::string machine_type;  // printers: may be empty
  bool measured = true;      // printers: it knows how large the machine is
  std::string settings;      // the text of a profile
};

// All of them, each kind in the order of its names.
[[nodiscard]] std::span<const PresetText> preset_texts();

// ENSURES: an error names all presets of that kind.
[[nodiscard]] core::Result<Preset> find_preset(PresetKind kind, std::string_view name);

// "printer", "filament", "quality".
[[nodiscard]] std::string_view preset_kind_word(PresetKind kind);

}  // namespace host
