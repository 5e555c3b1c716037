// The virtual controller's G2 and G3: as Marlin, it makes straight blocks of an arc, and says `ok`
// when the planner has taken the last one.
#include <algorithm>
#include <cmath>

#include "firmware_link/virtual/virtual_firmware.h"

namespace firmware_link {
namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

void VirtualController::Firmware::arc(std::int64_t code, std::string_view text) {
  const auto i = word(text, 'I', 3);
  const auto j = word(text, 'J', 3);
  const auto r = word(text, 'R', 3);
  if (!i && !j && !r) {
    print("Error:G2/G3 bad parameters\n");
    return;
  }
  const double x0 = position_.mm(0);
  const double y0 = position_.mm(1);
  const auto end = [&](char letter, double from) {
    const auto value = word(text, letter, 3);
    if (!value) return from;
    return static_cast<double>(*value) * 1e-3 + (position_.relative() ? from : 0);
  };
  const double x1 = end('X', x0);
  const double y1 = end('Y', y0);
  ArcWay way;
  if (r) {
    const double radius = std::abs(static_cast<double>(*r) * 1e-3);
    const double half = std::hypot(x1 - x0, y1 - y0) / 2;
    way.length_mm = radius >= half && radius > 0 ? 2 * radius * std::asin(half / radius) : 2 * half;
    move(text, &way);
    return;
  }
  const double ci = static_cast<double>(i.value_or(0)) * 1e-3;
  const double cj = static_cast<double>(j.value_or(0)) * 1e-3;
  const double side = code == 2 ? -1 : 1;
  const double start = std::atan2(-cj, -ci);
  double turn = (std::atan2(y1 - y0 - cj, x1 - x0 - ci) - start) * side;
  while (turn <= 1e-9) turn += 2 * kPi;
  way.radius_mm = std::hypot(ci, cj);
  way.centre_mm = {x0 + ci, y0 + cj};
  way.start = start;
  way.turn = turn * side;
  way.length_mm = turn * way.radius_mm;
  move(text, &way);
}

// Whether one of the arc's outermost points on x and y is off the bed.
bool VirtualController::Firmware::leaves_bed(const ArcWay& way) const {
  if (!position_.homed(0) || !position_.homed(1)) return false;
  const double low = std::min(way.start, way.start + way.turn);
  const double high = std::max(way.start, way.start + way.turn);
  for (auto quarter = std::llround(std::ceil(low / (kPi / 2)));; ++quarter) {
    const double angle = static_cast<double>(quarter) * (kPi / 2);
    if (angle > high) return false;
    const double x = way.centre_mm[0] + way.radius_mm * std::cos(angle);
    const double y = way.centre_mm[1] + way.radius_mm * std::sin(angle);
    const double right = x - options_.bed_origin_x_mm, back = y - options_.bed_origin_y_mm;
    if (right < 0 || back < 0 || right > options_.bed_x_mm || back > options_.bed_y_mm) return true;
  }
}

void VirtualController::Firmware::queue_arc(const ArcWay& way, PlannerMove block) {
  constexpr double kBlock_mm = kArcBlockUm * 1e-3;
  const double blocks = std::max(1.0, std::ceil(way.length_mm / kBlock_mm - 1e-9));
  const double side = way.turn < 0 ? -1 : 1;
  const double turn = way.turn / blocks;
  const double tangent = way.start + turn / 2 + side * kPi / 2;
  block.length_mm = way.length_mm / blocks;
  block.direction = {std::cos(tangent), std::sin(tangent), 0, block.direction[3]};
  // An arc has all directions of its plane.
  const VirtualAxes plane = {1, 1, 0, block.direction[3]};
  block.acceleration_mm_s2 = set_.limits.acceleration(plane);
  block.speed_mm_s = std::max(0.05, std::min(set_.limits.speed_mm_s(plane, position_.speed_mm_s()),
                                             std::sqrt(block.acceleration_mm_s2 * way.radius_mm)));
  queue_blocks(block, static_cast<std::size_t>(blocks), turn);
}

void VirtualController::Firmware::queue_blocks(const PlannerMove& block, std::size_t count,
                                               double turn) {
  blocks_.set(block, count, turn, totals_.commands);
  if (!blocks_.plan(planner_, pause_was_asked_, now_)) wait(Waiting::kPlannerSlot);
}

}  // namespace firmware_link
