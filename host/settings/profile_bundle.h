// Bundles of PrusaSlicer's profiles (PrusaResearch.ini): sections of printers, prints and filaments
// that inherit from one another.
//
//     [printer:*common*]                      a name between stars: to be inherited from only
//     [printer:Original Prusa MINI]           inherits = *common*; *mini*
//     [print:0.15mm QUALITY @MINI]            compatible_printers_condition = …
#pragma once

#include <string>
#include <vector>

#include "core/result.h"                  // Result
#include "host/settings/profile_lines.h"  // ForeignProfile, ProfileChoice, ProfileLine

namespace host {

[[nodiscard]] bool is_bundle(const std::vector<ProfileLine>& lines);

// The chosen printer, with its print and its filament, as one profile. The printer is a section's
// name, a model's, or a model's short name; of a model, its first variant. Print and filament are
// the printer's default ones unless they are named; if the bundle does not have these, the first
// ones that are made for the printer.
//
// An error names what there is to choose from.
[[nodiscard]] core::Result<ForeignProfile> chosen_from_bundle(const std::vector<ProfileLine>& lines,
                                                              const std::string& name,
                                                              const ProfileChoice& choice);

}  // namespace host
