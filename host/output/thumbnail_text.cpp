#include "host/output/thumbnail_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>

#include "host/output/base64.h"      // base64_of
#include "host/output/part_view.h"   // PartView
#include "host/output/png_writer.h"  // png_of
#include "host/output/qoi_writer.h"  // qoi_of
#include "host/system/text.h"        // trimmed

namespace host {
namespace {

constexpr std::size_t kLineCharacters = 78;

std::optional<int> side_of(std::string_view text) {
  int side = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, side);
  const bool whole = error == std::errc() && stop == end && !text.empty() && text.front() != '-';
  if (!whole || side < kThumbnailSideMin || side > kThumbnailSideMax) return std::nullopt;
  return side;
}

std::optional<ThumbnailFormat> format_of(std::string_view text) {
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  if (upper == "PNG") return ThumbnailFormat::kPng;
  if (upper == "QOI") return ThumbnailFormat::kQoi;
  return std::nullopt;
}

core::Result<Thumbnail> read_thumbnail(std::string_view text, ThumbnailFormat format) {
  const std::size_t slash = text.find('/');
  const std::string_view size = trimmed(text.substr(0, slash));
  const std::size_t cross = size.find('x');
  const auto width = side_of(size.substr(0, cross));
  const auto height = cross == std::string_view::npos ? width : side_of(size.substr(cross + 1));
  std::optional<ThumbnailFormat> own = format;
  if (slash != std::string_view::npos) own = format_of(trimmed(text.substr(slash + 1)));
  if (!width || !height || !own || cross == std::string_view::npos) {
    return core::Error{
        core::ErrorCode::kBadSetting,
        fmt::format("\"{}\" is no thumbnail: expected WIDTHxHEIGHT, {} … {} pixels each, and /PNG "
                    "or /QOI, as 220x124/PNG",
                    text, kThumbnailSideMin, kThumbnailSideMax)};
  }
  return Thumbnail{*width, *height, *own};
}

}  // namespace

core::Result<std::vector<Thumbnail>> read_thumbnails(std::string_view text,
                                                     ThumbnailFormat format) {
  std::vector<Thumbnail> thumbnails;
  text = trimmed(text);
  while (!text.empty()) {
    if (thumbnails.size() == kThumbnailsMax) {
      return core::Error{core::ErrorCode::kBadSetting,
                         fmt::format("there are more than {} thumbnails", kThumbnailsMax)};
    }
    const std::size_t comma = text.find(',');
    const core::Result<Thumbnail> one = read_thumbnail(trimmed(text.substr(0, comma)), format);
    if (!one.ok()) return one.error();
    thumbnails.push_back(one.value());
    text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
    if (comma != std::string_view::npos && trimmed(text).empty()) break;  // a comma at the end
  }
  return thumbnails;
}

void append_thumbnails(const PartView& view, const std::vector<Thumbnail>& thumbnails,
                       std::string& gcode) {
  for (const Thumbnail& thumbnail : thumbnails) {
    const RgbaPicture picture = view.picture(thumbnail.width, thumbnail.height);
    const bool qoi = thumbnail.format == ThumbnailFormat::kQoi;
    const std::string text = base64_of(qoi ? qoi_of(picture) : png_of(picture));
    const std::string_view name = qoi ? "thumbnail_QOI" : "thumbnail";
    gcode += fmt::format(";\n; {} begin {}x{} {}\n", name, thumbnail.width, thumbnail.height,
                         text.size());
    for (std::size_t at = 0; at < text.size(); at += kLineCharacters) {
      gcode += "; ";
      gcode.append(text, at, kLineCharacters);
      gcode += '\n';
    }
    gcode += fmt::format("; {} end\n;\n", name);
  }
}

}  // namespace host
