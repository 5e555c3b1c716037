// The parts that are laid onto one bed (plate.h): opened, but not yet placed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/result.h"            // Result
#include "core/settings.h"          // Settings
#include "host/part/bed_placing.h"  // Shift
#include "host/part/opened_part.h"  // OpenedPart, OpenOptions

namespace host {

struct PlatePart {
  std::string path;
  std::string title;
  core::Settings settings;  // as it was opened
  OpenedPart opened;
  std::vector<Shift> places;  // of its copies, from where it was opened; of the same number always
  std::string name = {};      // of its object
  std::vector<std::size_t> items = {};  // OpenOptions::items
  bool ended = false;
};

// For messages.
[[nodiscard]] std::string part_title_of(const std::string& path);

// As settings: of each file one part, or both pieces of it where it is cut.
[[nodiscard]] std::vector<core::Settings> pieces_of(const core::Settings& settings);

// Each in a share of the sort's memory. Errors: those of open_plate().
[[nodiscard]] core::Result<std::vector<PlatePart>> open_parts(const std::vector<std::string>& paths,
                                                              const core::Settings& settings,
                                                              const OpenOptions& options);

// The same parts, with those of several items (part_items.h) split up. Such a file is read once
// more, and again for each of its items, and none of it is held.
[[nodiscard]] core::Result<std::vector<PlatePart>> with_items_apart(std::vector<PlatePart> parts,
                                                                    const core::Settings& settings,
                                                                    const OpenOptions& options);

}  // namespace host
