#include "host/output/output_format.h"

#include <array>
#include <filesystem>

namespace host {
namespace {

struct NamedFormat {
  const char* name;
  OutputFormat format;
};

constexpr std::array kOutputFormats = {
    NamedFormat{"gcode", OutputFormat::kGcode},
    NamedFormat{"gco", OutputFormat::kGcode},
    NamedFormat{"g", OutputFormat::kGcode},
    NamedFormat{"cli", OutputFormat::kCli},
    NamedFormat{"cli-binary", OutputFormat::kCliBinary},
    NamedFormat{"cli-roads", OutputFormat::kCliRoads},
    NamedFormat{"lsif", OutputFormat::kLsif},
    NamedFormat{"ssl", OutputFormat::kSliceV0},
    NamedFormat{"svg", OutputFormat::kSvg},
};

bool is_nameless(const std::string& output) {
  return output == "-" || output.rfind("/dev/", 0) == 0;
}

// Without the dot, in lower case.
std::string ending_of(const std::string& output) {
  std::string ending = std::filesystem::path(output).extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  for (char& c : ending) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return ending;
}

}  // namespace

std::vector<std::string> output_format_names() {
  std::vector<std::string> names;
  names.reserve(std::size(kOutputFormats));
  for (const NamedFormat& named : kOutputFormats) names.emplace_back(named.name);
  return names;
}

std::optional<OutputFormat> output_format_of(const std::string& output, const std::string& word) {
  if (word.empty() && is_nameless(output)) return OutputFormat::kGcode;
  const std::string name = word.empty() ? ending_of(output) : word;
  for (const NamedFormat& named : kOutputFormats) {
    if (name == named.name) return named.format;
  }
  return std::nullopt;
}

std::optional<PictureFormat> picture_format_of(const std::string& output) {
  const std::string ending = is_nameless(output) ? "" : ending_of(output);
  if (ending.empty() || ending == "svg") return PictureFormat::kSvg;
  if (ending == "png") return PictureFormat::kPng;
  return std::nullopt;
}

LayerContents contents_of(OutputFormat format, const std::string& word) {
  if (word == "walls") return LayerContents::kWalls;
  if (word == "quickslice") return LayerContents::kWallsForQuickSlice;
  const bool told_apart = format == OutputFormat::kCli || format == OutputFormat::kCliBinary ||
                          format == OutputFormat::kLsif;
  return word.empty() && told_apart ? LayerContents::kWalls : LayerContents::kSlices;
}

}  // namespace host
