// Opens a part, whatever kind of file it is, as a source of slices.
//
// The kind is told by the content, never by the name. The part is set on the bed: its lowest point
// at height 0, and in the plane at the bed's centre or where the settings say.
#pragma once

#include <string>

#include "core/result.h"            // Result
#include "core/settings.h"          // Settings
#include "host/part/opened_part.h"  // OpenedPart, OpenOptions

namespace host {

// `path` may be "-" for standard input. Errors name the file, the place, the cause and what to do:
// kUnreadable for the file itself, kBadPart for its content and for a part without height or
// thinner than a layer, kOutOfBounds for one larger than the bed, the axis or the coordinates.
// Some of these come from OpenedPart::read_rest(), where there is more to read than a look ahead.
[[nodiscard]] core::Result<OpenedPart> open_part(const std::string& path,
                                                 const core::Settings& settings,
                                                 const OpenOptions& options = {});

// With the rest read.
[[nodiscard]] core::Result<OpenedPart> open_whole_part(const std::string& path,
                                                       const core::Settings& settings,
                                                       const OpenOptions& options = {});

}  // namespace host
