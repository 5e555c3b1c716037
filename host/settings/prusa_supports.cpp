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
  if (settings.supports == core::SupportPlace::kEverywhere &&
      values.text("support_material_buildplate_only") == "1") {
    settings.supports = core::SupportPlace::kBed;
  }
  const std::string_view style = values.text("support_material_style");
  if (style == "tree" || style == "organic") settings.support_style = core::SupportStyle::kTree;
  // What needs a support for PrusaSlicer; where nothing is held for it, there is nothing to tell.
  const bool holds = settings.supports != core::SupportPlace::kOff && settings.support_auto;
  if (const auto angle = values.number("support_material_threshold"); angle && *angle > 0) {
    settings.overhang_angle_degrees = holds ? 90 - *angle : core::Settings().overhang_angle_degrees;
  }
}

void take_prusa_support_distances(const ProfileValues& profile, const IsAssigned& assigned,
                                  core::Settings& settings) {
  const Profile values(profile);
  const auto set_gap = [&](int core::Settings::*gap, const char* key, double distance_mm) {
    if (!assigned(key)) settings.*gap = gap_layers(distance_mm, settings.layer_height);
  };
  using S = core::Settings;
  if (const auto top = values.number("support_material_contact_distance")) {
    set_gap(&S::support_top_gap_layers, "support_top_gap_layers", *top);
    set_gap(&S::support_bottom_gap_layers, "support_bottom_gap_layers", *top);
  }
  if (const auto bottom = values.number("support_material_bottom_contact_distance");
      bottom && *bottom > 0) {
    set_gap(&S::support_bottom_gap_layers, "support_bottom_gap_layers", *bottom);
  }
  std::string_view sideways = values.text("support_material_xy_spacing");
  if (!sideways.ends_with('%') || assigned("support_xy_distance")) return;
  sideways.remove_suffix(1);
  const core::Result<double> percent = read_number(sideways, "");
  if (!percent.ok() || percent.value() < 0) return;
  const auto outer = values.number("external_perimeter_extrusion_width");
  const double width_mm = outer && *outer > 0 ? *outer : settings.road_width.mm();
  settings.support_xy_distance = core::Length::from_mm(width_mm * percent.value() / 100);
}

}  // namespace host
