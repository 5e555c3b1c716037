// Modifiers of a 3MF, as PrusaSlicer and OrcaSlicer write them: where they lie in each slice, what
// they change, and what is told of the rest.
#include "host/part/modified_layers.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "host/part/part_file.h"
#include "tests/support/marked_files.h"
#include "tests/support/part_folder.h"
#include "tests/support/part_slices.h"

using core::Settings;
using test::MarkedBody;
using test::PartFolder;

namespace {

host::OpenedPart opened(const std::string& path, const Settings& settings) {
  auto part = host::open_whole_part(path, settings);
  REQUIRE_MESSAGE(part.ok(), (part.ok() ? "" : part.error().message));
  return std::move(part).value();
}

bool says(const std::vector<std::string>& texts, const std::string& word) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& text) { return text.find(word) != std::string::npos; });
}

// A block, and a modifier over its right half, from 2 to 6 mm up.
std::vector<MarkedBody> half(const char* plastic, const char* modifier,
                             test::BodySettings settings) {
  return {{parts::box({0, 0, 0}, 40, 20, 8), plastic},
          {parts::box({20, -5, 2}, 30, 30, 4), modifier, {}, std::move(settings)}};
}

}  // namespace

TEST_CASE("a modifier lies where the file places it, in both slicers' words") {
  const PartFolder folder;
  const std::string prusa =
      folder.add_text("prusa.3mf", test::prusa_threemf(half("ModelPart", "ParameterModifier",
                                                            {{"name", "Right half"},
                                                             {"source_volume_id", "1"},
                                                             {"fill_density", "50%"},
                                                             {"fill_pattern", "gyroid"},
                                                             {"perimeters", "5"},
                                                             {"top_solid_layers", "7"}})));
  const std::string orca =
      folder.add_text("orca.3mf", test::orca_threemf(half("normal_part", "modifier_part",
                                                          {{"name", "Right half"},
                                                           {"extruder", "1"},
                                                           {"sparse_infill_density", "50%"},
                                                           {"sparse_infill_pattern", "gyroid"},
                                                           {"wall_loops", "5"},
                                                           {"top_shell_layers", "7"}})));
  for (const std::string& path : {prusa, orca}) {
    CAPTURE(path);
    host::OpenedPart part = opened(path, Settings());
    CHECK_EQ(part.modifiers,
             std::vector<std::string>{
                 "modifier 'Right half': density 50 %, pattern gyroid, 5 perimeters"});
    CHECK(says(part.summary.warnings, path == prusa ? "not used: top_solid_layers = 7; within"
                                                    : "not used: top_shell_layers = 7; within"));
    CHECK_EQ(part.summary.warnings.size(), 1);
    CHECK_EQ(part.summary.height.mm(), doctest::Approx(8));
    const std::vector<core::Slice> slices = test::all_slices(part);
    REQUIRE_EQ(slices.size(), 40);
    for (const core::Slice& slice : slices) {
      CAPTURE(slice.index);
      CHECK_EQ(slice.region.area_mm2(), doctest::Approx(800));
      const bool within = slice.index >= 10 && slice.index < 30;
      REQUIRE_EQ(slice.areas != nullptr, within);
      if (!within) continue;
      REQUIRE_EQ(slice.areas->size(), 1);
      CHECK_EQ(slice.areas->front().change.density, 0.5);
      CHECK_EQ(slice.areas->front().change.perimeters, 5);
      CHECK(slice.areas->front().change.pattern == core::LoosePattern::kGyroid);
      const core::Box box = slice.areas->front().region.box(), all = slice.region.box();
      CHECK_EQ(box.min.x - all.min.x, 200'000);
      CHECK_EQ(box.max.x - all.min.x, 500'000);
      CHECK_EQ(box.min.y - all.min.y, -50'000);
    }
  }
}

TEST_CASE("an object's own settings hold for its plastic, and a modifier within them") {
  const PartFolder folder;
  const std::string path = folder.add_text(
      "part.3mf",
      test::prusa_threemf(half("ModelPart", "ParameterModifier", {{"fill_density", "80%"}}), {""},
                          {{"name", "Block"}, {"fill_density", "5%"}}));
  host::OpenedPart part = opened(path, Settings());
  CHECK(says(part.modifiers, "object 'Block': density 5 %"));
  const std::vector<core::Slice> slices = test::all_slices(part);
  REQUIRE(slices[20].areas);
  REQUIRE_EQ(slices[20].areas->size(), 2);
  CHECK_EQ((*slices[20].areas)[0].change.density, 0.05);
  CHECK_EQ((*slices[20].areas)[0].region.area_mm2(), doctest::Approx(800));
  CHECK_EQ((*slices[20].areas)[1].change.density, 0.8);
}

TEST_CASE("modifiers go with a part that is scaled, turned, cut, and has negative parts") {
  const PartFolder folder;
  std::vector<MarkedBody> bodies =
      half("ModelPart", "ParameterModifier", {{"fill_density", "80%"}});
  bodies.push_back({parts::box({5, 5, -1}, 3, 3, 20), "NegativeVolume"});
  const std::string path = folder.add_text("part.3mf", test::prusa_threemf(bodies));
  Settings settings;
  settings.part_scale = "2";
  settings.part_rotation = "90";
  settings.cut = "6 upper";
  host::OpenedPart part = opened(path, settings);
  const std::vector<core::Slice> slices = test::all_slices(part);
  REQUIRE_EQ(slices.size(), 50);
  REQUIRE(slices[0].areas);
  CHECK_EQ(slices[0].region.area_mm2(), doctest::Approx(4 * (800 - 9)));
  CHECK_EQ(slices[0].areas->front().region.area_mm2(), doctest::Approx(4 * 900));
  CHECK_EQ(slices[0].areas->front().region.box().min.y - slices[0].region.box().min.y, 400'000);
  CHECK(slices[29].areas);
  CHECK_FALSE(slices[30].areas);
}

TEST_CASE("speeds and flows are read in both slicers' words") {
  const PartFolder folder;
  const std::string prusa =
      folder.add_text("prusa.3mf", test::prusa_threemf(half("ModelPart", "ParameterModifier",
                                                            {{"name", "Slow"},
                                                             {"perimeter_speed", "40"},
                                                             {"external_perimeter_speed", "50%"},
                                                             {"solid_infill_speed", "80"},
                                                             {"top_solid_infill_speed", "25%"},
                                                             {"gap_fill_speed", "0"},
                                                             {"bridge_speed", "15"},
                                                             {"bridge_flow_ratio", "0.9"}})));
  const std::string orca =
      folder.add_text("orca.3mf", test::orca_threemf(half("normal_part", "modifier_part",
                                                          {{"name", "Slow"},
                                                           {"inner_wall_speed", "40"},
                                                           {"outer_wall_speed", "20"},
                                                           {"internal_solid_infill_speed", "80"},
                                                           {"top_surface_speed", "20"},
                                                           {"gap_infill_speed", "0"},
                                                           {"bridge_speed", "15"},
                                                           {"bridge_flow", "0.9"}})));
  Settings settings;
  settings.bridge_flow = 1.8;
  settings.internal_bridge_flow = 1.2;
  for (const std::string& path : {prusa, orca}) {
    CAPTURE(path);
    host::OpenedPart part = opened(path, settings);
    CHECK_EQ(part.modifiers,
             std::vector<std::string>{
                 "modifier 'Slow': perimeters at 40 mm/s, outer perimeters at 20 mm/s, solid at 80 "
                 "mm/s, tops at 20 mm/s, bridges at 15 mm/s, flow of bridges 0.9"});
    CHECK(says(part.summary.warnings, path == prusa ? "not used: gap_fill_speed = 0;"
                                                    : "not used: gap_infill_speed = 0;"));
    const std::vector<core::Slice> slices = test::all_slices(part);
    REQUIRE(slices[20].areas);
    const core::AreaChange& change = slices[20].areas->front().change;
    core::AreaChange expected;
    expected.value(core::LaidValue::kPerimeterSpeed) = 40;
    expected.value(core::LaidValue::kOuterPerimeterSpeed) = 20;
    expected.value(core::LaidValue::kSolidSpeed) = 80;
    expected.value(core::LaidValue::kTopSpeed) = 20;
    for (const auto which : {core::LaidValue::kBridgeSpeed, core::LaidValue::kInternalBridgeSpeed,
                             core::LaidValue::kOverhangSpeed3, core::LaidValue::kOverhangSpeed4}) {
      expected.value(which) = 15;
    }
    expected.value(core::LaidValue::kBridgeFlow) = 0.9 / 1.8;
    expected.value(core::LaidValue::kInternalBridgeFlow) = 0.9 / 1.2;
    for (std::size_t i = 0; i < core::kLaidValueCount; ++i) {
      CAPTURE(i);
      REQUIRE_EQ(change.laid[i].has_value(), expected.laid[i].has_value());
      if (change.laid[i]) CHECK_EQ(*change.laid[i], doctest::Approx(*expected.laid[i]));
    }
  }
}

TEST_CASE("OrcaSlicer's switches: what they turn off changes nothing, and is not named") {
  const PartFolder folder;
  const auto file = [&](const char* on) {
    return folder.add_text(std::string(on) + ".3mf",
                           test::orca_threemf(half("normal_part", "modifier_part",
                                                   {{"print_flow_ratio", "1.1"},
                                                    {"outer_wall_flow_ratio", "0.95"},
                                                    {"set_other_flow_ratios", on},
                                                    {"overhang_3_4_speed", "50%"},
                                                    {"outer_wall_speed", "30"},
                                                    {"enable_overhang_speed", on}})));
  };
  for (const char* on : {"0", "1"}) {
    CAPTURE(on);
    host::OpenedPart part = opened(file(on), Settings());
    CHECK(part.summary.warnings.empty());
    const std::vector<core::Slice> slices = test::all_slices(part);
    REQUIRE(slices[20].areas);
    const core::AreaChange& change = slices[20].areas->front().change;
    CHECK_EQ(change.value(core::LaidValue::kFlow), 1.1);
    CHECK_EQ(change.value(core::LaidValue::kOuterPerimeterFlow).has_value(), *on == '1');
    CHECK_EQ(change.value(core::LaidValue::kOverhangSpeed3).value_or(0), *on == '1' ? 15 : 0);
  }
}

TEST_CASE("a modifier that asks for what the part has is told, and leaves no trace") {
  const PartFolder folder;
  Settings settings;
  settings.outer_perimeter_speed_mm_s = 30;
  const test::BodySettings same{{"name", "Same"},
                                {"fill_density", "20%"},
                                {"fill_pattern", "rectilinear"},
                                {"external_perimeter_speed", "50%"},
                                {"infill_speed", "60"},
                                {"bridge_flow_ratio", "1"}};
  const std::string path = folder.add_text(
      "same.3mf", test::prusa_threemf(half("ModelPart", "ParameterModifier", same)));
  host::OpenedPart part = opened(path, settings);
  CHECK(says(part.modifiers, "density 20 %"));
  for (const core::Slice& slice : test::all_slices(part)) CHECK_FALSE(slice.areas);
  // Within an object with another density it does count.
  const std::string within = folder.add_text(
      "within.3mf", test::prusa_threemf(half("ModelPart", "ParameterModifier", same), {""},
                                        {{"name", "Block"}, {"fill_density", "5%"}}));
  host::OpenedPart block = opened(within, settings);
  const std::vector<core::Slice> slices = test::all_slices(block);
  REQUIRE(slices[20].areas);
  REQUIRE_EQ(slices[20].areas->size(), 2);
  CHECK_EQ(slices[20].areas->back().change.density, 0.2);
  CHECK_FALSE(slices[20].areas->back().change.lays_otherwise());
}

TEST_CASE("what can't be changed within a part is named, never lost") {
  const PartFolder folder;
  const auto file = [&](const char* name, test::BodySettings settings) {
    return folder.add_text(
        name, test::prusa_threemf(half("ModelPart", "ParameterModifier", std::move(settings))));
  };
  const std::string odd = file(
      "odd.3mf", {{"name", "Odd"}, {"fill_pattern", "hilbertcurve"}, {"fill_density", "many"}});
  host::OpenedPart part = opened(odd, Settings());
  CHECK(part.modifiers.empty());
  CHECK(says(part.summary.warnings,
             "modifier 'Odd': not used: fill_pattern = hilbertcurve, "
             "fill_density = many"));
  for (const core::Slice& slice : test::all_slices(part)) CHECK_FALSE(slice.areas);
  const std::string dense = file("dense.3mf", {{"fill_density", "90%"}});
  Settings lightning;
  lightning.loose_pattern = core::LoosePattern::kLightning;
  CHECK(says(opened(dense, lightning).summary.warnings, "not used: fill_density = 90%"));
  const std::string branches = file("branches.3mf", {{"fill_pattern", "lightning"}});
  CHECK(says(opened(branches, Settings()).summary.warnings, "not used: fill_pattern = lightning"));
  // Where the number of perimeters can't differ.
  const std::string thick = file("thick.3mf", {{"perimeters", "6"}});
  Settings vase, every_two, bare;
  vase.spiral_vase = true;
  every_two.loose_every_layers = 2;
  bare.perimeters = 0;
  for (const Settings& settings : {lightning, vase, every_two, bare}) {
    CHECK(says(opened(thick, settings).summary.warnings, "not used: perimeters = 6"));
  }
  for (const char* wrong : {"0", "-1", "2.5", "51", "many"}) {
    CAPTURE(wrong);
    const std::string path = file("wrong.3mf", {{"perimeters", wrong}});
    CHECK(says(opened(path, Settings()).summary.warnings, "not used: perimeters = "));
  }
  CHECK(opened(thick, Settings()).summary.warnings.empty());
  const std::string none = file("none.3mf", {{"name", "Nothing"}});
  CHECK(says(opened(none, Settings()).summary.warnings, "1 modifier left out"));
}
