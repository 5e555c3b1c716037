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
                                                             {"perimeters", "5"}})));
  const std::string orca =
      folder.add_text("orca.3mf", test::orca_threemf(half("normal_part", "modifier_part",
                                                          {{"name", "Right half"},
                                                           {"extruder", "1"},
                                                           {"sparse_infill_density", "50%"},
                                                           {"sparse_infill_pattern", "gyroid"},
                                                           {"wall_loops", "5"}})));
  for (const std::string& path : {prusa, orca}) {
    CAPTURE(path);
    host::OpenedPart part = opened(path, Settings());
    CHECK_EQ(part.modifiers,
             std::vector<std::string>{"modifier 'Right half': density 50 %, pattern gyroid"});
    CHECK(says(part.summary.warnings, path == prusa ? "not used: perimeters = 5; within"
                                                    : "not used: wall_loops = 5; within"));
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
  const std::string none = file("none.3mf", {{"name", "Nothing"}});
  CHECK(says(opened(none, Settings()).summary.warnings, "1 modifier left out"));
}
