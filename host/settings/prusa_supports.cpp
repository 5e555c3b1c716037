#include "host/settings/prusa_supports.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/result.h"                  // Result
#include "host/settings/settings_text.h"  // read_number

namespace host {
namespace {

constexpr double kGapLayersMax = 10;

class Profile {
 public:
  explicit Profile(const ProfileValues& values) : values_(values) {}

  [[nodiscard]] std::string_view text(std::string_view key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? std::string_view() : first_value(found->second);
  }

  [[nodiscard]] std::optional<double> number(std::string_view key) const {
    const core::Result<double> read = read_number(text(key), "");
    return read.ok() ? std::optional(read.value()) : std::nullopt;
  }

 private:
  const ProfileValues& values_;
};

int gap_layers(double distance_mm, core::Length layer_height) {
  return static_cast<int>(
      std::clamp(std::round(distance_mm / layer_height.mm()), 0.0, kGapLayersMax));
}

}  // namespace

void take_prusa_supports(const ProfileValues& profile, core::Settings& settings) {
  const Profile values(profile);
  if (values.text("support_material_auto") == "0") settings.supports = core::SupportPlace::kOff;
  if (settings.supports == core::SupportPlace::kEverywhere &&
      values.text("support_material_buildplate_only") == "1") {
    settings.supports = core::SupportPlace::kBed;
  }
  // What needs a support for PrusaSlicer; without any, it is nothing to be told of.
  if (const auto angle = values.number("support_material_threshold"); angle && *angle > 0) {
    settings.overhang_angle_degrees = settings.supports == core::SupportPlace::kOff
                                          ? core::Settings().overhang_angle_degrees
                                          : 90 - *angle;
  }
  if (const auto top = values.number("support_material_contact_distance")) {
    settings.support_top_gap_layers = gap_layers(*top, settings.layer_height);
    settings.support_bottom_gap_layers = settings.support_top_gap_layers;
  }
  if (const auto bottom = values.number("support_material_bottom_contact_distance");
      bottom && *bottom > 0) {
    settings.support_bottom_gap_layers = gap_layers(*bottom, settings.layer_height);
  }
  std::string_view sideways = values.text("support_material_xy_spacing");
  if (!sideways.ends_with('%')) return;
  sideways.remove_suffix(1);
  const core::Result<double> percent = read_number(sideways, "");
  if (!percent.ok() || percent.value() < 0) return;
  const auto outer = values.number("external_perimeter_extrusion_width");
  const double width_mm = outer && *outer > 0 ? *outer : settings.road_width.mm();
  settings.support_xy_distance = core::Length::from_mm(width_mm * percent.value() / 100);
}

}  // namespace host
