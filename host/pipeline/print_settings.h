// All settings of a print: those that decide the G-code (core::Settings), and those of the link.
// Units, ranges and help texts are in host/settings/part_rows.h and machine_rows.h.
#pragma once

#include <utility>

#include "core/settings.h"  // Settings

namespace host {

// Whether lines are packed (MeatPack) before they are sent.
enum class PackUse {
  kAuto,  // where the controller offers it
  kOff,
};

struct PrintSettings : core::Settings {
  PrintSettings() = default;
  // The defaults of the link. NOLINTNEXTLINE(google-explicit-constructor)
  PrintSettings(core::Settings settings) : core::Settings(std::move(settings)) {}

  // The link.
  PackUse meatpack = PackUse::kOff;
  double wait_limit_s = 0;  // least time to wait for an answer; 0: depends on the command
};

}  // namespace host
