#include "host/part/plate_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/limits.h"                // kObjectsMax
#include "host/part/part_file.h"        // open_part
#include "host/part/transform_words.h"  // read_cut

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Length;
using core::Result;
using core::Status;

// Where each part lies is decided here: it is opened in the middle of the bed.
core::Settings before_placing(core::Settings settings) {
  settings.centre = true;
  settings.part_x = settings.part_y = Length();
  return settings;
}

Error too_many(std::size_t objects) {
  return {ErrorCode::kOutOfBounds, fmt::format("{} objects are more than the {} that one print may "
                                               "have; print fewer copies",
                                               objects, core::kObjectsMax)};
}

// Each item of the part, which is read for each of them and not held. REQUIRES: it was read.
Status split(PlatePart whole, const OpenOptions& options, std::vector<PlatePart>& parts) {
  for (const PartObject& object : whole.opened.summary.objects) {
    OpenOptions alone = options;
    alone.items = object.items;
    Result<OpenedPart> opened = read_whole(open_part(whole.path, whole.settings, alone));
    if (!opened.ok()) return opened.error();
    opened.value().layers.reset();
    parts.push_back(
        {whole.path, whole.title, whole.settings, std::move(opened).value(), whole.places});
    parts.back().name = object.title;
    parts.back().items = object.items;
  }
  return {};
}

}  // namespace

std::string part_title_of(const std::string& path) {
  return path == "-" ? "standard input" : std::filesystem::path(path).filename().string();
}

std::vector<core::Settings> pieces_of(const core::Settings& settings) {
  const std::optional<CutWords> cut = read_cut(settings.cut).value();
  std::vector<core::Settings> pieces{before_placing(settings)};
  if (!cut || cut->piece != CutPiece::kBoth) return pieces;
  pieces.push_back(pieces.front());
  pieces[0].cut = fmt::format("{} lower", cut->height_mm);
  pieces[1].cut = fmt::format("{} upper", cut->height_mm);
  return pieces;
}

Result<std::vector<PlatePart>> open_parts(const std::vector<std::string>& paths,
                                          const core::Settings& settings,
                                          const OpenOptions& options) {
  const std::vector<core::Settings> pieces = pieces_of(settings);
  const std::size_t parts_count = paths.size() * pieces.size();
  const std::size_t objects = parts_count * static_cast<std::size_t>(settings.copies);
  if (objects > core::kObjectsMax) return too_many(objects);
  if (settings.spiral_vase) {
    return Error{ErrorCode::kBadSetting,
                 "spiral_vase lays one contour in a layer: print one object"};
  }
  OpenOptions each = options;
  each.stream_pipes = false;
  each.sort_bytes = std::max(kSortBytesMin, options.sort_bytes / parts_count);
  each.on_facet = {};  // where they lie is not known yet: OpenedPart::draw
  std::vector<PlatePart> parts;
  for (const std::string& path : paths) {
    if (path == "-" && pieces.size() > 1) {
      return Error{ErrorCode::kBadSetting,
                   "cut: standard input is read once, and its two pieces are read one beside the "
                   "other; print one of them, or the part from a file"};
    }
    for (const core::Settings& piece : pieces) {
      Result<OpenedPart> opened = open_part(path, piece, each);
      if (!opened.ok()) return opened.error();
      parts.push_back({path, part_title_of(path), piece, std::move(opened).value(),
                       std::vector<Shift>(static_cast<std::size_t>(settings.copies))});
      parts.back().name = path;
    }
  }
  return parts;
}

Result<std::vector<PlatePart>> with_items_apart(std::vector<PlatePart> parts,
                                                const core::Settings& settings,
                                                const OpenOptions& options) {
  std::vector<PlatePart> apart;
  for (PlatePart& part : parts) {
    if (part.opened.items > 1) {
      part.opened = OpenedPart();
      Result<OpenedPart> read = read_whole(open_part(part.path, part.settings, options));
      if (!read.ok()) return read.error();
      part.opened.summary = std::move(read).value().summary;
    }
    if (part.opened.summary.objects.empty()) {
      apart.push_back(std::move(part));
      continue;
    }
    if (Status done = split(std::move(part), options, apart); !done.ok()) return done.error();
  }
  const std::size_t objects = apart.size() * static_cast<std::size_t>(settings.copies);
  if (objects > core::kObjectsMax) return too_many(objects);
  return apart;
}

}  // namespace host
