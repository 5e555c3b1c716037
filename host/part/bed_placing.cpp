#include "host/part/bed_placing.h"

#include <algorithm>

#include "core/bed.h"     // Bed
#include "core/limits.h"  // kCoordinateMax
#include "core/units.h"   // kUnitsPerMm

namespace host {
namespace {

core::Point shifted(core::Point p, const Shift& shift) {
  return {static_cast<std::int32_t>(p.x + shift.x), static_cast<std::int32_t>(p.y + shift.y)};
}

}  // namespace

Shift shift_to_bed(const MeshExtent& extent, const core::Settings& settings) {
  const core::Box& box = extent.box;
  if (!settings.centre) {
    return {settings.part_x.units() - box.min.x, settings.part_y.units() - box.min.y,
            -extent.lowest_z};
  }
  // Computed in half units, so that it is rounded once; the sums stay below 2^32.
  const auto centred = [](std::int64_t bed, std::int64_t low, std::int64_t high) {
    return (bed - low - high) / 2;
  };
  return {centred(settings.bed_x.units(), box.min.x, box.max.x),
          centred(settings.bed_y.units(), box.min.y, box.max.y), -extent.lowest_z};
}

core::Triangle shifted(core::Triangle triangle, const Shift& shift) {
  for (core::Vertex& corner : triangle.corners) {
    const core::Point p = shifted(core::Point{corner.x, corner.y}, shift);
    corner = {p.x, p.y, corner.z + shift.z};
  }
  return triangle;
}

core::Box shifted(const core::Box& box, const Shift& shift) {
  return {shifted(box.min, shift), shifted(box.max, shift)};
}

core::Status check_on_bed(const MeshExtent& extent, const Shift& shift,
                          const core::Settings& settings, const std::string& name) {
  const core::Box& box = extent.box;
  const std::int64_t left = box.min.x + shift.x, right = box.max.x + shift.x;
  const std::int64_t front = box.min.y + shift.y, back = box.max.y + shift.y;
  const std::int64_t bed_x = settings.bed_x.units(), bed_y = settings.bed_y.units();
  const std::string bed = mm_text(bed_x) + " × " + mm_text(bed_y) + " mm";
  const auto refused = [&name](const std::string& cause) {
    return core::Error{core::ErrorCode::kOutOfBounds, name + ": " + cause};
  };
  if (right - left > bed_x || back - front > bed_y) {
    return refused("the part is " + mm_text(right - left) + " × " + mm_text(back - front) +
                   " mm, the bed " + bed + "; make it smaller (--scale), or check bed_x and bed_y");
  }
  if (left < 0 || front < 0 || right > bed_x || back > bed_y) {
    return refused("the part would lie at " + mm_text(left) + " … " + mm_text(right) + ", " +
                   mm_text(front) + " … " + mm_text(back) + " mm on a bed of " + bed +
                   "; change part_x and part_y, or centre it");
  }
  if (!settings.bed_shape.empty()) {
    const core::Bed outline(settings);
    for (const core::Point point : extent.reach.points()) {
      const core::Point at = shifted(point, shift);
      if (outline.holds(at)) continue;
      return refused("the part would lie at " + mm_text(at.x) + ", " + mm_text(at.y) +
                     " mm from the corner of a bed of " + bed +
                     ", which is beyond its outline; scale or move the part, or check bed_shape");
    }
  }
  if (right > core::kCoordinateMax || back > core::kCoordinateMax) {
    return refused("the part would lie farther than " + mm_text(core::kCoordinateMax) +
                   " mm from the bed's corner; move it");
  }
  const std::int64_t axis = settings.axis_z.units(), top = extent.highest_z + shift.z;
  if (axis != 0 && top > axis) {
    const bool raft = settings.raft_layers > 0;
    return refused("the part is " + mm_text(top) + " mm high, the axis " +
                   (raft ? "above the raft " : "") + mm_text(axis) +
                   " mm; scale the part, or check axis_z" + (raft ? " and raft_layers" : ""));
  }
  return {};
}

std::string mm_text(std::int64_t units) {
  std::string text = units < 0 ? "-" : "";
  const std::uint64_t size =
      units < 0 ? 0 - static_cast<std::uint64_t>(units) : static_cast<std::uint64_t>(units);
  const auto per_mm = static_cast<std::uint64_t>(core::kUnitsPerMm);
  text += std::to_string(size / per_mm);
  std::string rest = std::to_string(per_mm + size % per_mm).substr(1);
  rest.erase(rest.find_last_not_of('0') + 1);
  return rest.empty() ? text : text + "." + rest;
}

}  // namespace host
