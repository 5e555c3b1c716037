// The format that `rind slice` writes, by the file's name or by --format.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/formats/layer_writer.h"  // LayerContents

namespace host {

enum class OutputFormat { kGcode, kCli, kCliBinary, kCliRoads, kLsif, kSliceV0, kSvg };

// The words of --format: "gcode", "cli", "cli-binary" …; also the endings of files' names.
[[nodiscard]] std::vector<std::string> output_format_names();

// `word` is that of --format, or empty. Standard output and devices, which have no ending, get
// G-code. Nullopt if neither the word nor the name is known.
[[nodiscard]] std::optional<OutputFormat> output_format_of(const std::string& output,
                                                           const std::string& word);

enum class PictureFormat { kSvg, kPng };

// By the name's ending: .svg, .png; a name without one gets SVG. Nullopt: another ending.
[[nodiscard]] std::optional<PictureFormat> picture_format_of(const std::string& output);

// `word` is that of --contents: "walls", "slices", "quickslice", or empty, which means walls if the
// format can distinguish them from insides.
[[nodiscard]] LayerContents contents_of(OutputFormat format, const std::string& word);

}  // namespace host
