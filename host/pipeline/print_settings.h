// All settings of a print: those that decide the motions (core::Settings), those of the link, and
// those of what is written into a file for people.
// Units, ranges and help texts are in host/settings/part_rows.h and machine_rows.h.
#pragma once

#include <string>
#include <utility>

#include "core/settings.h"                 // Settings
#include "host/output/thumbnail_format.h"  // ThumbnailFormat

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

  // Whose limits the machine's are taken to be, where its own are not known: for messages.
  std::string limits_assumed;

  // Pictures of the part in a file (thumbnail_text.h).
  std::string thumbnails = "32x32, 300x300";
  ThumbnailFormat thumbnails_format = ThumbnailFormat::kPng;
};

}  // namespace host
