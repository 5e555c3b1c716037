#include "host/part/cut_plane.h"

#include <fmt/format.h>

#include <cmath>

#include "core/slices/plane_crossing.h"  // plane_crossing
#include "core/units.h"                  // kUnitsPerMm
#include "host/part/bed_placing.h"       // mm_text
#include "host/part/transform_words.h"   // read_cut

namespace host {

using core::Error;
using core::ErrorCode;
using core::Triangle;
using core::Vertex;

bool is_cut(const core::Settings& settings) { return read_cut(settings.cut).value().has_value(); }

core::Status check_one_piece(const core::Settings& settings, const std::string& name) {
  const std::optional<CutWords> words = read_cut(settings.cut).value();
  if (!words || words->piece != CutPiece::kBoth) return {};
  const std::string height = fmt::format("{:g}", words->height_mm);
  return Error{ErrorCode::kBadSetting, name + ": cut = " + settings.cut +
                                           ": both pieces can't be printed at once; say which "
                                           "one: --cut '" +
                                           height + " lower' or --cut '" + height + " upper'"};
}

core::Result<std::optional<CutPlane>> CutPlane::of(const core::Settings& settings,
                                                   std::int64_t lowest_z, std::int64_t highest_z,
                                                   const std::string& name) {
  const std::optional<CutWords> words = read_cut(settings.cut).value();
  if (!words) return std::optional<CutPlane>();
  const auto refused = [&](const std::string& cause) {
    return Error{ErrorCode::kBadSetting, name + ": cut = " + settings.cut + ": " + cause};
  };
  if (core::Status one = check_one_piece(settings, name); !one.ok()) return one.error();
  const double above = words->height_mm * core::kUnitsPerMm / (1 - settings.shrinkage_z);
  const std::int64_t height = std::llround(above);
  if (height <= 0 || height >= highest_z - lowest_z) {
    return refused("the part is " + mm_text(highest_z - lowest_z) +
                   " mm high, so there is nothing to cut; give a height within it");
  }
  return std::optional(CutPlane(lowest_z + height, words->piece == CutPiece::kUpper));
}

std::vector<Triangle> CutPlane::clipped(const Triangle& triangle) const {
  const auto within = [this](const Vertex& v) { return upper_ ? v.z >= z_ : v.z <= z_; };
  std::vector<Vertex> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex& from = triangle.corners[i];
    const Vertex& to = triangle.corners[(i + 1) % 3];
    if (within(from)) corners.push_back(from);
    // An end on the plane is a corner already.
    if ((from.z < z_ && to.z > z_) || (from.z > z_ && to.z < z_)) {
      const core::Point at = core::plane_crossing(from, to, 2 * z_);
      corners.push_back({at.x, at.y, z_});
    }
  }
  std::vector<Triangle> pieces;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    pieces.push_back({{corners[0], corners[i - 1], corners[i]}});
  }
  return pieces;
}

Triangle CutPlane::face(const core::Box& box) const {
  return {{Vertex{box.min.x, box.min.y, z_}, Vertex{box.max.x, box.min.y, z_},
           Vertex{box.max.x, box.max.y, z_}}};
}

}  // namespace host
