#include "host/settings/prusa_supports.h"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "host/settings/settings_file.h"
#include "host/settings/whole_settings.h"
#include "tests/support/temporary_folder.h"

using core::SupportPlace;

namespace {

host::LoadedSettings loaded(const std::string& lines) {
  const std::string head =
      "top_solid_layers = 4\nbottom_solid_layers = 3\nraft_layers = 0\nlayer_height = "
      "0.2\nextrusion_width = 0.45\n";
  auto result = host::read_settings(head + lines, "my.ini", host::PrintSettings());
  if (!result.ok()) FAIL(result.error().message);
  return std::move(result).value();
}

bool tells(const host::LoadedSettings& profile, const std::string& word) {
  for (const std::string& line : profile.left_out) {
    if (line.find(word) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("a PrusaSlicer profile's supports are taken over") {
  const auto profile = loaded(
      "support_material = 1\nsupport_material_threshold = 40\n"
      "support_material_contact_distance = 0.25\nsupport_material_xy_spacing = 60%\n"
      "support_material_spacing = 2\nsupport_material_interface_layers = 3\n"
      "support_material_bottom_interface_layers = -1\nsupport_material_style = snug\n");
  const core::Settings& settings = profile.settings;
  CHECK(settings.supports == SupportPlace::kEverywhere);
  CHECK_EQ(settings.overhang_angle_degrees, 50);
  CHECK_EQ(settings.support_top_gap_layers, 1);
  CHECK_EQ(settings.support_bottom_gap_layers, 1);
  CHECK_EQ(settings.support_xy_distance.mm(), doctest::Approx(0.27));
  CHECK_EQ(settings.support_spacing.mm(), 2);
  CHECK_EQ(settings.support_interface_layers, 3);
  CHECK_FALSE(tells(profile, "xy_spacing"));
  CHECK_FALSE(tells(profile, "style"));
  CHECK(settings.support_style == core::SupportStyle::kGrid);
}

TEST_CASE("tree supports of both kinds are taken for rind's") {
  for (const std::string style : {"tree", "organic"}) {
    CAPTURE(style);
    const auto profile = loaded("support_material = 1\nsupport_material_style = " + style +
                                "\nsupport_tree_angle = 35\nsupport_tree_tip_diameter = 1\n"
                                "support_tree_branch_diameter = 3\n"
                                "support_tree_branch_diameter_angle = 4\n");
    const core::Settings& settings = profile.settings;
    CHECK(settings.support_style == core::SupportStyle::kTree);
    CHECK_EQ(settings.support_branch_angle_degrees, 35);
    CHECK_EQ(settings.support_tip_diameter.mm(), 1);
    CHECK_EQ(settings.support_branch_diameter.mm(), 3);
    CHECK_EQ(settings.support_branch_diameter_angle_degrees, 4);
    CHECK_FALSE(tells(profile, "style"));
    CHECK_FALSE(tells(profile, "tree"));
  }
}

TEST_CASE("from the bed only, by hand only, or not at all") {
  const auto none = loaded("support_material = 0\nsupport_material_threshold = 60\n");
  CHECK(none.settings.supports == SupportPlace::kOff);
  CHECK_EQ(none.settings.overhang_angle_degrees, core::Settings().overhang_angle_degrees);
  CHECK(loaded("support_material = 1\nsupport_material_buildplate_only = 1\n").settings.supports ==
        SupportPlace::kBed);
  CHECK(loaded("support_material = 1\n").settings.support_auto);
  // Only what is enforced is held, and nothing is told of the rest.
  const auto by_hand =
      loaded("support_material = 1\nsupport_material_auto = 0\nsupport_material_threshold = 60\n");
  CHECK(by_hand.settings.supports == SupportPlace::kEverywhere);
  CHECK_FALSE(by_hand.settings.support_auto);
  CHECK_FALSE(tells(by_hand, "support_material_auto"));
  CHECK_EQ(by_hand.settings.overhang_angle_degrees, core::Settings().overhang_angle_degrees);
}

TEST_CASE("distances become layers and shares of widths by the print's own heights and widths") {
  const test::TemporaryFolder folder;
  const std::string profile = folder.write(
      "my.ini",
      "top_solid_layers = 4\nbottom_solid_layers = 3\nraft_layers = 0\nfill_density = 15%\n"
      "layer_height = 0.2\nextrusion_width = 0.45\nsupport_material = 1\n"
      "support_material_contact_distance = 0.2\nsupport_material_bottom_contact_distance = 0.4\n"
      "support_material_xy_spacing = 60%\n");
  using Assignments = std::vector<std::pair<std::string, std::string>>;
  const auto with = [&](Assignments assignments) -> core::Settings {
    const auto whole = host::whole_settings({profile, false, std::move(assignments)});
    if (!whole.ok()) FAIL(whole.error().message);
    return whole.value().settings;
  };
  const core::Settings as_it_is = with({});
  CHECK_EQ(as_it_is.support_top_gap_layers, 1);
  CHECK_EQ(as_it_is.support_bottom_gap_layers, 2);
  CHECK_EQ(as_it_is.support_xy_distance.mm(), doctest::Approx(0.27));
  const core::Settings finer = with({{"layer_height", "0.1"}, {"road_width", "0.6"}});
  CHECK_EQ(finer.support_top_gap_layers, 2);
  CHECK_EQ(finer.support_bottom_gap_layers, 4);
  CHECK_EQ(finer.support_xy_distance.mm(), doctest::Approx(0.36));
  const core::Settings by_hand = with(
      {{"support_top_gap_layers", "3"}, {"layer_height", "0.1"}, {"support_xy_distance", "0.7"}});
  CHECK_EQ(by_hand.support_top_gap_layers, 3);
  CHECK_EQ(by_hand.support_bottom_gap_layers, 4);
  CHECK_EQ(by_hand.support_xy_distance.mm(), 0.7);
}

TEST_CASE("what rind's supports do not have is told") {
  const auto profile = loaded(
      "support_material = 1\nsupport_material_with_sheath = 0\ndont_support_bridges = 0\n"
      "support_material_pattern = honeycomb\n");
  for (const char* word : {"with_sheath", "dont_support_bridges", "pattern"}) {
    CAPTURE(std::string(word));
    CHECK(tells(profile, word));
  }
  CHECK_FALSE(tells(loaded("support_material = 0\nsupport_material_with_sheath = 0\n"), "sheath"));
}
