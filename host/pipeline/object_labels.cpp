#include "host/pipeline/object_labels.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

#include "core/units.h"                 // Length
#include "firmware_link/wire/limits.h"  // kTextBytesMax

namespace host {
namespace {

using firmware_link::Flavor;

bool are_told(const core::Settings& settings, Flavor flavor) {
  switch (settings.object_labels) {
    case core::ObjectLabels::kAuto:
      return flavor != Flavor::kMarlin;
    case core::ObjectLabels::kFirmware:
      return true;
    case core::ObjectLabels::kComments:
    case core::ObjectLabels::kOff:
      break;
  }
  return false;
}

// With its middle and its box in the printer's coordinates, in whole mm, as far as a line has room.
std::string klipper_definition(const PartObject& object, const core::Settings& settings) {
  const auto x_mm = [&](std::int64_t units) {
    return (core::Length::from_units(units) + settings.bed_origin_x).mm();
  };
  const auto y_mm = [&](std::int64_t units) {
    return (core::Length::from_units(units) + settings.bed_origin_y).mm();
  };
  const core::Box& box = object.box;
  std::string line = fmt::format("EXCLUDE_OBJECT_DEFINE NAME={}", object.name);
  const std::string centre =
      fmt::format(" CENTER={:.0f},{:.0f}", x_mm((std::int64_t{box.min.x} + box.max.x) / 2),
                  y_mm((std::int64_t{box.min.y} + box.max.y) / 2));
  if (line.size() + centre.size() <= firmware_link::kTextBytesMax) line += centre;
  return line;
}

}  // namespace

ObjectLabels::ObjectLabels(const std::vector<PartObject>& objects, const core::Settings& settings,
                           Flavor flavor)
    : flavor_(flavor) {
  if (!are_told(settings, flavor)) return;
  for (const PartObject& object : objects) names_.push_back(object.name);
  if (names_.empty()) return;
  if (flavor == Flavor::kKlipper) {
    for (const PartObject& object : objects) {
      definitions_.push_back(klipper_definition(object, settings));
    }
    return;
  }
  definitions_.push_back(fmt::format("M486 T{}", names_.size()));
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (flavor == Flavor::kRepRapFirmware) {
      definitions_.push_back(fmt::format("M486 S{} A\"{}\"", i, names_[i]));
    } else {
      definitions_.push_back(fmt::format("M486 S{}", i));
      definitions_.push_back(fmt::format("M486 A{}", names_[i]));
    }
  }
  definitions_.emplace_back("M486 S-1");
}

std::string ObjectLabels::start(int object) const {
  const auto index = static_cast<std::size_t>(object);
  if (index >= names_.size()) return {};
  if (flavor_ != Flavor::kKlipper) return fmt::format("M486 S{}", object);
  return "EXCLUDE_OBJECT_START NAME=" + names_[index];
}

std::string ObjectLabels::end(int object) const {
  const auto index = static_cast<std::size_t>(object);
  if (index >= names_.size()) return {};
  if (flavor_ != Flavor::kKlipper) return "M486 S-1";
  return "EXCLUDE_OBJECT_END NAME=" + names_[index];
}

}  // namespace host
