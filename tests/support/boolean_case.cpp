#include "tests/support/boolean_case.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>

#include "core/units.h"
#include "tests/support/region_checks.h"
#include "tools/oracles/reference_boolean.h"

namespace test {
namespace {

using core::FillRule;
using core::Point;
using core::Region;
using core::Ring;

// Nearer to an edge than this nothing is said: rounding moves it by up to half a unit in x and y.
constexpr double kClear = 0.72;
// Between two results that are both rounded.
constexpr double kWidthMax = 2;
// From coordinates of about 2^28 on Boost.Polygon's is wrong by any amount now and then.
constexpr std::int32_t kReferenceScaleMax = 1000;
constexpr int kGridMiddle = 8;
constexpr std::array<std::int32_t, 5> kScales = {1, 3, 50, 1000, 1 << 25};
constexpr std::size_t kRingsMax = 4;

bool filled(int winding, FillRule rule) {
  return rule == FillRule::kNonZero ? winding != 0 : winding > 0;
}

// From rings of any kind, single points among them.
bool clear_of(const std::vector<Ring>& rings, double x, double y) {
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      const double dx = static_cast<double>(b.x) - a.x, dy = static_cast<double>(b.y) - a.y;
      const double length = dx * dx + dy * dy;
      const double along = length > 0 ? ((x - a.x) * dx + (y - a.y) * dy) / length : 0;
      const double t = std::clamp(along, 0.0, 1.0);
      const double ex = x - a.x - t * dx, ey = y - a.y - t * dy;
      if (ex * ex + ey * ey < kClear * kClear) return false;
    }
  }
  return true;
}

// Calls visit(x, y) for points all over the grid, none of them on its lines.
template <typename Visit>
void for_places(std::int32_t scale, Visit visit) {
  for (int row = -kGridMiddle; row < kGridMiddle; row += 2) {
    for (int column = -kGridMiddle; column < kGridMiddle; column += 2) {
      const double shift = 0.13 * (row + kGridMiddle);
      visit((column + 0.37 + shift - static_cast<int>(shift)) * scale, (row + 0.81) * scale);
    }
  }
}

struct Operands {
  Region region[3];
};

Operands operands_of(const BooleanCase& input) {
  Operands operands;
  for (int i = 0; i < 3; ++i) {
    std::vector<Ring> rings = input.rings[i];
    if (i == 1 && input.shares_rings) {
      rings = core::unite(core::clean(rings, input.rule), operands.region[0]).rings();
    }
    operands.region[i] = core::clean(rings, input.rule);
  }
  return operands;
}

std::string check_result(const char* name, const Region& result, const Operands& operands,
                         std::int32_t scale, const std::function<bool(bool, bool, bool)>& wanted) {
  if (!is_clean(result)) return std::string(name) + " is not clean";
  std::string wrong;
  for_places(scale, [&](double x, double y) {
    bool in[3] = {};
    for (int i = 0; i < 3; ++i) {
      if (!clear_of(operands.region[i].rings(), x, y)) return;
      in[i] = winding_number(operands.region[i].rings(), x, y) == 1;
    }
    if (winding_number(result.rings(), x, y) != (wanted(in[0], in[1], in[2]) ? 1 : 0)) {
      wrong = std::string(name) + " is wrong at " + std::to_string(x) + ":" + std::to_string(y);
    }
  });
  return wrong;
}

double width_of(const Ring& ring) {
  const double perimeter = Region::from_clean_rings({ring}).perimeter_mm() * core::kUnitsPerMm;
  return std::max(0.0, core::doubled_area_units(ring)) / perimeter;
}

// Points of the piece, clear of all operands, at which ours isn't what is wanted.
std::string wrong_within(const Ring& piece, const Region& ours,
                         std::span<const Region* const> operands,
                         const std::function<bool(bool, bool)>& wanted) {
  core::Box box;
  for (const Point p : piece) box.add(p);
  constexpr int kPointsAcross = 60;
  const double width = static_cast<double>(box.max.x) - box.min.x;
  const double height = static_cast<double>(box.max.y) - box.min.y;
  for (int i = 0; i < kPointsAcross * kPointsAcross; ++i) {
    const double x = box.min.x + width * (i % kPointsAcross + 0.371) / kPointsAcross;
    const double y = box.min.y + height * (i / kPointsAcross + 0.619) / kPointsAcross;
    if (winding_number({piece}, x, y) == 0) continue;
    bool in[2] = {};
    bool clear = true;
    for (std::size_t k = 0; k < 2 && clear; ++k) {
      clear = clear_of(operands[k]->rings(), x, y);
      in[k] = winding_number(operands[k]->rings(), x, y) == 1;
    }
    if (clear && winding_number(ours.rings(), x, y) != (wanted(in[0], in[1]) ? 1 : 0)) {
      return " is wrong at " + std::to_string(x) + ":" + std::to_string(y);
    }
  }
  return {};
}

}  // namespace

BooleanCase boolean_case(std::span<const std::uint8_t> bytes) {
  BooleanCase input;
  if (bytes.empty()) return input;
  input.scale = kScales[bytes[0] % kScales.size()];
  input.rule = bytes[0] & 0x40 ? FillRule::kPositive : FillRule::kNonZero;
  input.shares_rings = bytes[0] >= 0xE0;
  // A byte is a point; one in sixteen ends the ring, and every second of those the operand.
  int operand = 0, ends = 0;
  Ring ring;
  const auto end_ring = [&] {
    std::vector<Ring>& rings = input.rings[operand];
    if (!ring.empty() && rings.size() < kRingsMax) rings.push_back(ring);
    ring.clear();
  };
  for (const std::uint8_t byte : bytes.subspan(1)) {
    if (byte % 16 == 15) {
      end_ring();
      if (++ends % 2 == 0) operand = (operand + 1) % 3;
    } else {
      ring.push_back(
          {(byte % 16 - kGridMiddle) * input.scale, (byte / 16 - kGridMiddle) * input.scale});
    }
  }
  end_ring();
  return input;
}

std::string check_operations(const BooleanCase& input) {
  const Operands operands = operands_of(input);
  const Region &a = operands.region[0], &b = operands.region[1], &c = operands.region[2];
  for (int i = 0; i < 3; ++i) {
    if (!is_clean(operands.region[i])) return "clean() is not clean";
    if (i == 1 && input.shares_rings) continue;
    std::string wrong;
    for_places(input.scale, [&](double x, double y) {
      if (!clear_of(input.rings[i], x, y)) return;
      const bool in = filled(winding_number(input.rings[i], x, y), input.rule);
      if (winding_number(operands.region[i].rings(), x, y) != (in ? 1 : 0)) {
        wrong = "clean() is wrong at " + std::to_string(x) + ":" + std::to_string(y);
      }
    });
    if (!wrong.empty()) return wrong;
  }
  const Region all = core::intersect(core::intersect(a, b), c);
  const struct {
    const char* name;
    Region result, other;
    std::function<bool(bool, bool, bool)> wanted;
  } operations[] = {
      {"unite", core::unite(a, b), core::unite(b, a),
       [](bool in_a, bool in_b, bool) { return in_a || in_b; }},
      {"intersect", core::intersect(a, b), core::intersect(b, a),
       [](bool in_a, bool in_b, bool) { return in_a && in_b; }},
      {"subtract", core::subtract(a, b), core::subtract(a, b),
       [](bool in_a, bool in_b, bool) { return in_a && !in_b; }},
      {"exclusive_or", core::exclusive_or(a, b), core::exclusive_or(b, a),
       [](bool in_a, bool in_b, bool) { return in_a != in_b; }},
      {"intersect, twice", all, core::intersect(core::intersect(b, a), c),
       [](bool in_a, bool in_b, bool in_c) { return in_a && in_b && in_c; }},
  };
  for (const auto& operation : operations) {
    std::string wrong =
        check_result(operation.name, operation.result, operands, input.scale, operation.wanted);
    if (!wrong.empty()) return wrong;
    if (operation.result != operation.other) {
      return std::string(operation.name) + " depends on the order of its operands";
    }
  }
  return {};
}

std::string check_against_reference(const BooleanCase& input, BooleanComparison& comparison) {
  if (input.scale > kReferenceScaleMax) return {};
  const Operands operands = operands_of(input);
  const Region &a = operands.region[0], &b = operands.region[1];
  namespace reference = core::reference;
  const struct {
    const char* name;
    std::array<const Region*, 2> operands;
    Region ours, theirs;
    std::function<bool(bool, bool)> wanted;
  } pairs[] = {
      {"clean",
       {&operands.region[2], &operands.region[2]},
       operands.region[2],
       reference::clean(input.rings[2], input.rule),
       [](bool in, bool) { return in; }},
      {"unite",
       {&a, &b},
       core::unite(a, b),
       reference::unite(a, b),
       [](bool in_a, bool in_b) { return in_a || in_b; }},
      {"intersect",
       {&a, &b},
       core::intersect(a, b),
       reference::intersect(a, b),
       [](bool in_a, bool in_b) { return in_a && in_b; }},
      {"subtract",
       {&a, &b},
       core::subtract(a, b),
       reference::subtract(a, b),
       [](bool in_a, bool in_b) { return in_a && !in_b; }},
      {"exclusive_or",
       {&a, &b},
       core::exclusive_or(a, b),
       reference::exclusive_or(a, b),
       [](bool in_a, bool in_b) { return in_a != in_b; }},
  };
  for (const auto& pair : pairs) {
    ++comparison.compared;
    const Region difference = reference::exclusive_or(pair.ours, pair.theirs);
    for (const Ring& piece : difference.rings()) {
      const double width = width_of(piece);
      comparison.widest = std::max(comparison.widest, width);
      if (width <= kWidthMax) continue;
      ++comparison.wider;
      const std::string wrong = wrong_within(piece, pair.ours, pair.operands, pair.wanted);
      if (!wrong.empty()) return pair.name + wrong;
    }
  }
  return {};
}

}  // namespace test
