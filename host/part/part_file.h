// Opens a part from any kind of file as a source of slices.
//
// The kind is recognised by the content, never by the name. The part is placed on the bed: its
// lowest point at height 0, and in the plane at the bed's centre or where the settings say. Its
// slices know no raft, its summary does (core/raft_heights.h).
#pragma once

#include <string>

#include "core/result.h"            // Result
#include "core/settings.h"          // Settings
#include "host/part/opened_part.h"  // OpenedPart, OpenOptions

namespace host {

// `path` may be "-" for standard input. Errors name the file, the position in it, the cause and
// what to do: kUnreadable for the file itself; kBadPart for its content, and for a part without
// height or thinner than a layer; kOutOfBounds for a part larger than the bed, the axis or the
// coordinates. If the file is larger than the look-ahead, some errors come from
// OpenedPart::read_rest().
[[nodiscard]] core::Result<OpenedPart> open_part(const std::string& path,
                                                 const core::Settings& settings,
                                                 const OpenOptions& options = {});

// The part, with its read_rest() done.
[[nodiscard]] core::Result<OpenedPart> read_whole(core::Result<OpenedPart> part);

// open_part() and read_whole().
[[nodiscard]] core::Result<OpenedPart> open_whole_part(const std::string& path,
                                                       const core::Settings& settings,
                                                       const OpenOptions& options = {});

}  // namespace host
