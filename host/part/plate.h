// Several parts, copies of them, or the two pieces of a part that is cut, on one bed, printed layer
// by layer together.
//
//     a.stl ──> its slices ─┬─ moved ──┐
//                           └─ moved ──┤ copies          each slice is read once, and moved to
//     b.stl ──> its slices ─── moved ──┴──> one slice    the place of each copy
//
// Boxes of objects don't meet (arrangement.h), so a slice of all of them is the rings of each, one
// after another, and which object a point belongs to is told by the boxes alone.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/result.h"            // Result
#include "core/settings.h"          // Settings
#include "host/part/opened_part.h"  // OpenedPart, OpenOptions

namespace host {

// Whether the parts are several objects: more than one file, copies or pieces of one.
[[nodiscard]] bool is_plate(const std::vector<std::string>& paths, const core::Settings& settings);

// Opens each part as open_part() does, in a share of the sort's memory, and arranges them. Where
// each lies is known when all of them have been read to their end.
// Errors: those of open_part(), of a part that does not fit, and of arranged(); more than
// kObjectsMax objects; one whose size is not known before it is printed; a spiral vase. When slices
// are read: layers of different heights.
// COSTS: memory of each file's slices, not of its copies'. REQUIRES: one path or more.
[[nodiscard]] core::Result<OpenedPart> open_plate(const std::vector<std::string>& paths,
                                                  const core::Settings& settings,
                                                  const OpenOptions& options);

}  // namespace host
