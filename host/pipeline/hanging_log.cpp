#include "host/pipeline/hanging_log.h"

#include <fmt/format.h>

#include <algorithm>

namespace host {
namespace {

using core::HangingKind;

constexpr std::array<HangingKind, core::kHangingKinds> kKinds = {
    HangingKind::kIsland, HangingKind::kSpan, HangingKind::kOverhang};

std::string counted(HangingKind kind, std::int64_t count) {
  const bool one = count == 1;
  switch (kind) {
    case HangingKind::kIsland:
      return one ? "1 island begins in the air" : fmt::format("{} islands begin in the air", count);
    case HangingKind::kSpan:
      return one ? "1 bridge is longer than bridge_max"
                 : fmt::format("{} bridges are longer than bridge_max", count);
    case HangingKind::kOverhang:
      break;
  }
  return one ? "1 overhang is steeper than overhang_angle_degrees"
             : fmt::format("{} overhangs are steeper than overhang_angle_degrees", count);
}

std::string size_text(const core::HangingPlace& place) {
  return fmt::format("{:.1f} {}", place.size, place.kind == HangingKind::kSpan ? "mm" : "mm²");
}

std::string place_text(const HangingSpot& spot) {
  return fmt::format("({:.1f}, {:.1f}) mm on the bed, layer {}, {:g} mm high",
                     core::Length::from_units(spot.place.at.x).mm(),
                     core::Length::from_units(spot.place.at.y).mm(), spot.layer + 1,
                     spot.height.mm());
}

std::string line(HangingKind kind, const HangingLog::Kind& found) {
  std::string text = counted(kind, found.count);
  if (found.layers > 1) text += fmt::format(", in {} layers", found.layers);
  const char* before = ": ";
  for (const HangingSpot& spot : found.first) {
    text += fmt::format("{}{} at {}", before, size_text(spot.place), place_text(spot));
    before = "; ";
  }
  if (found.count <= static_cast<std::int64_t>(found.first.size())) return text;
  return text + fmt::format("; …; the largest {} at {}", size_text(found.largest.place),
                            place_text(found.largest));
}

}  // namespace

std::string floating_word(OnFloating action) {
  return action == OnFloating::kStop ? "stop" : "warn";
}

OnFloating floating_of(const std::string& word) {
  return word == "stop" ? OnFloating::kStop : OnFloating::kWarn;
}

std::string hanging_text(const HangingSpot& spot) {
  const std::string size = size_text(spot.place), place = place_text(spot);
  switch (spot.place.kind) {
    case HangingKind::kIsland:
      return fmt::format("an island of {} begins in the air at {}", size, place);
    case HangingKind::kSpan:
      return fmt::format("a bridge of {} is longer than bridge_max at {}", size, place);
    case HangingKind::kOverhang:
      break;
  }
  return fmt::format("an overhang of {} is steeper than overhang_angle_degrees at {}", size, place);
}

void HangingLog::add(core::LayerIndex layer, core::Length bottom,
                     const core::HangingPlaces& places) {
  for (const HangingKind kind : kKinds) {
    const std::int64_t count = places.counts[static_cast<std::size_t>(kind)];
    if (count == 0) continue;
    Kind& found = kinds_[static_cast<std::size_t>(kind)];
    found.count += count;
    ++found.layers;
    for (const core::HangingPlace& place : places.largest) {
      if (place.kind != kind) continue;
      const HangingSpot spot{layer, bottom, place};
      if (found.first.size() < kHangingTold) found.first.push_back(spot);
      if (place.size > found.largest.place.size) found.largest = spot;
    }
  }
}

std::vector<std::string> HangingLog::summary() const {
  std::vector<std::string> lines;
  for (const HangingKind kind : kKinds) {
    if (of(kind).count > 0) lines.push_back(line(kind, of(kind)));
  }
  return lines;
}

}  // namespace host
