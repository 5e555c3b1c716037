// What `rind slice` writes, by the name of the file or by --format.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/formats/layer_writer.h"  // LayerContents

namespace host {

enum class OutputFormat { kGcode, kCli, kCliBinary, kCliRoads, kLsif, kSliceV0, kSvg };

// What --format takes: "gcode", "cli", "cli-binary" …; files that are named so end so.
[[nodiscard]] std::vector<std::string> output_format_names();

// `word` is --format's, or empty. What has no name to tell by, standard output or a device, gets
// what a printer reads. Nothing where neither tells.
[[nodiscard]] std::optional<OutputFormat> output_format_of(const std::string& output,
                                                           const std::string& word);

// Whether a picture may have that name: pictures are SVG.
[[nodiscard]] bool may_be_picture(const std::string& output);

// `word` is --contents': "walls", "slices", "quickslice", or empty: walls where the format tells
// them from insides.
[[nodiscard]] LayerContents contents_of(OutputFormat format, const std::string& word);

}  // namespace host
