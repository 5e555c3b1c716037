#include "host/formats/stl.h"

#include <cmath>
#include <utility>

#include "core/limits.h"                 // kCoordinateMax
#include "core/units.h"                  // kUnitsPerMm
#include "host/formats/format_limits.h"  // kPlaneMaxMm
#include "host/formats/stl_kinds.h"      // open_binary_stl, open_text_stl

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

static_assert(kPlaneMaxMm * core::kUnitsPerMm <= core::kCoordinateMax);

// Bytes that decide the kind.
constexpr std::size_t kLookBytes = 4096;

std::string number_text(double mm) {
  std::string text = std::to_string(mm);
  const std::size_t end = text.find_last_not_of('0');
  return text.substr(0, text[end] == '.' ? end : end + 1);
}

}  // namespace

Result<std::unique_ptr<StlReader>> StlReader::open(InputFile file) {
  const Result<std::string_view> window = file.window(kLookBytes);
  if (!window.ok()) return window.error();
  const auto refused = [&file](const std::string& cause) {
    return Error{ErrorCode::kBadPart, file.name() + ": " + cause};
  };
  if (window.value().empty()) return refused("the file is empty; export the part again");
  if (window.value().starts_with("PK\x03\x04")) {
    return refused("byte 0: a zip archive (3MF?), which can't be read; export the part as STL");
  }
  if (is_binary_stl(file, window.value())) return open_binary_stl(std::move(file));
  switch (text_kind(window.value())) {
    case StlText::kNone:
      return open_binary_stl(std::move(file));
    case StlText::kStl:
      return open_text_stl(std::move(file));
    case StlText::kNotFacets:
      return refused(
          "line 2: begins like an ASCII STL, but 'facet' does not follow; export the part again");
    case StlText::kOther:
      break;
  }
  return refused(
      "line 1: text of no kind that is known ('rind formats' lists them); export the part as STL");
}

Error StlReader::bad_part(const std::string& place, const std::string& cause) const {
  return {ErrorCode::kBadPart, file_.name() + ": " + place + ": " + cause};
}

Error StlReader::not_snapped(const Corners& corners, const std::string& place) const {
  for (const auto& corner : corners) {
    const double x = corner[0] * unit_mm_, y = corner[1] * unit_mm_, z = corner[2] * unit_mm_;
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) break;
    const bool far = std::abs(x) > kPlaneMaxMm || std::abs(y) > kPlaneMaxMm;
    if (!far && std::abs(z) <= kHeightMaxMm) continue;
    return {ErrorCode::kOutOfBounds,
            file_.name() + ": " + place + ": a corner is at " + number_text(x) + ", " +
                number_text(y) + ", " + number_text(z) + " mm, farther than " +
                number_text(far ? kPlaneMaxMm : kHeightMaxMm) +
                " mm from the origin; move the part to the origin, or check its unit"};
  }
  return bad_part(place, "a coordinate is not a finite number; repair the mesh");
}

}  // namespace host
