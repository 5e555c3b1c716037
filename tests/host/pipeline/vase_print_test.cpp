// A spiral vase as motions: one road that rises from the floor to the top.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "core/regions/polyline.h"
#include "core/roads/road.h"
#include "host/pipeline/pipeline.h"
#include "tests/host/print_rig.h"
#include "tests/support/part_folder.h"

using core::LayerIndex;
using core::Length;

namespace {

struct LaidLayer {
  Length bottom, top;
  int travels = 0;
  int lifts = 0;        // without extrusion
  int retractions = 0;  // and returns
  bool rises = false;
  double mm = 0;
  double filament_mm = 0;
};

struct Laid {
  std::map<LayerIndex, LaidLayer> layers;
  double longest_join_mm = 0;  // between the end of a turn and the start of the next
  std::vector<std::string> warnings;
};

Laid lay(const core::Settings& settings, const std::string& path, int threads = 1) {
  host::PrintPlan print_plan = print_test::open(settings, path);
  print_plan.threads = threads;
  Laid laid;
  LaidLayer* layer = nullptr;
  core::Point at;
  Length z;
  bool turn_begins = false;
  host::PipelineOutputs outputs;
  outputs.on_motion = [&](const core::Motion& motion, const auto&) {
    if (const auto* start = std::get_if<core::LayerStart>(&motion)) {
      layer = &laid.layers[start->index];
      layer->top = start->top;
      layer->bottom = start->top - start->height;
      turn_begins = true;
    } else if (layer == nullptr) {
      return true;
    } else if (const auto* travel = std::get_if<core::Travel>(&motion)) {
      ++layer->travels;
      at = travel->to;
    } else if (const auto* lift = std::get_if<core::Lift>(&motion)) {
      ++layer->lifts;
      z = lift->to;
    } else if (std::holds_alternative<core::MoveFilament>(motion)) {
      ++layer->retractions;
    } else if (const auto* line = std::get_if<core::Extrude>(&motion)) {
      const double mm = core::distance_mm(at, line->to);
      if (!line->z && turn_begins && layer->travels == 0) {
        laid.longest_join_mm = std::max(laid.longest_join_mm, mm);
      }
      turn_begins = false;
      layer->mm += mm;
      layer->filament_mm += line->filament_mm;
      at = line->to;
      if (line->z) {
        layer->rises = true;
        CHECK_GE(*line->z, z);
        CHECK_LE(*line->z, layer->top);
        z = *line->z;
      }
    }
    return true;
  };
  host::PipelineSignals signals;
  host::GeometryStatistics statistics;
  REQUIRE(host::run_pipeline(print_plan, outputs, signals, statistics).ok());
  laid.warnings = signals.warnings.take();
  return laid;
}

core::Settings vase_settings() {
  core::Settings settings;
  settings.spiral_vase = true;
  settings.skirt_loops = 0;
  return settings;
}

double full_filament(const core::Settings& settings, double mm) {
  const double d = settings.filament_diameter.mm();
  return mm * core::bead_area_mm2(settings.road_width, settings.layer_height) /
         (std::numbers::pi * d * d / 4);
}

}  // namespace

TEST_CASE("above the floor there is one turn a layer, without travel, lift or retraction") {
  const test::PartFolder folder;
  const std::string path = folder.add("dome.stl", parts::dome(9));
  const core::Settings settings = vase_settings();
  const Laid laid = lay(settings, path);
  REQUIRE_EQ(laid.layers.size(), 45);
  // Up to there, turns rest on one another.
  const LayerIndex first = 4, steep = 35;
  for (const auto& each : laid.layers) {
    const LayerIndex index = each.first;
    const LaidLayer& layer = each.second;
    CAPTURE(index);
    REQUIRE_EQ(layer.rises, index >= first);
    if (index <= first || index >= steep) continue;
    CHECK_EQ(layer.travels, 0);
    CHECK_EQ(layer.lifts, 0);
    CHECK_EQ(layer.retractions, 0);
    // What is sent is simplified, by up to 7 µm of a radius of 1 mm.
    CHECK(layer.filament_mm == doctest::Approx(full_filament(settings, layer.mm)).epsilon(0.01));
  }
  CHECK_LE(laid.longest_join_mm, 2 * settings.road_width.mm());
}

TEST_CASE("the first turn fills a wedge, and the last one leaves a flat top") {
  const test::PartFolder folder;
  const std::string path = folder.add("box.stl", parts::box({0, 0, 0}, 20, 12, 3));
  const core::Settings settings = vase_settings();
  const Laid laid = lay(settings, path);
  REQUIRE_EQ(laid.layers.size(), 15);
  const double once = full_filament(settings, 2 * (20 - 0.45 + 12 - 0.45));
  const auto filament = [&](LayerIndex index) { return laid.layers.at(index).filament_mm; };
  CHECK(filament(4) == doctest::Approx(once / 2).epsilon(0.001));
  for (LayerIndex index = 5; index < 14; ++index) {
    CHECK(filament(index) == doctest::Approx(once).epsilon(0.001));
  }
  CHECK(filament(14) == doctest::Approx(once * 1.5).epsilon(0.001));
}

TEST_CASE("where a narrow place parts the contour, layers are flat and the turns end before them") {
  const test::PartFolder folder;
  const parts::Part part =
      parts::together({parts::box({0, 0, 0}, 20, 10, 3), parts::box({0, 0, 3}, 8, 10, 1),
                       parts::box({8, 4.9, 3}, 4, 0.2, 1), parts::box({12, 0, 3}, 8, 10, 1),
                       parts::box({0, 0, 4}, 20, 10, 3)});
  const std::string path = folder.add("waist.stl", part);
  const core::Settings settings = vase_settings();
  const Laid laid = lay(settings, path);
  REQUIRE_EQ(laid.layers.size(), 35);
  const double once = full_filament(settings, 2 * (20 - 0.45 + 10 - 0.45));
  for (const auto& each : laid.layers) {
    const LayerIndex index = each.first;
    const LaidLayer& layer = each.second;
    CAPTURE(index);
    CHECK_EQ(layer.rises, index >= 4 && (index < 15 || index >= 20));
  }
  CHECK(laid.layers.at(14).filament_mm == doctest::Approx(once * 1.5).epsilon(0.001));
  CHECK(laid.layers.at(20).filament_mm == doctest::Approx(once / 2).epsilon(0.001));
}

TEST_CASE("of several contours the largest is laid, and it is said") {
  const test::PartFolder folder;
  const std::string path = folder.add(
      "two.stl", parts::together({parts::tube(8, 6, 3, 60), parts::box({20, 0, 0}, 5, 5, 3)}));
  const Laid laid = lay(vase_settings(), path);
  REQUIRE_EQ(laid.warnings.size(), 1);
  CHECK(laid.warnings.front().find("the part's layer 5 has 3 contours") != std::string::npos);
  for (LayerIndex index = 5; index < 14; ++index) {
    CHECK(laid.layers.at(index).mm == doctest::Approx(2 * std::numbers::pi * 7.775).epsilon(0.005));
  }
}

TEST_CASE("a turn over the hollow hangs in the air: it is told, and it starts anew") {
  const test::PartFolder folder;
  const std::string path = folder.add(
      "ledge.stl",
      parts::together({parts::box({0, 0, 0}, 20, 20, 3), parts::box({6, 6, 3}, 8, 8, 3)}));
  const core::Settings settings = vase_settings();
  const Laid laid = lay(settings, path);
  REQUIRE_EQ(laid.warnings.size(), 1);
  CHECK(laid.warnings.front().find("begins in the air") != std::string::npos);
  CHECK(laid.warnings.front().find("layer 16") != std::string::npos);
  const double wide = full_filament(settings, 4 * (20 - 0.45));
  const double narrow = full_filament(settings, 4 * (8 - 0.45));
  CHECK(laid.layers.at(14).filament_mm == doctest::Approx(wide * 1.5).epsilon(0.001));
  CHECK(laid.layers.at(15).filament_mm == doctest::Approx(narrow / 2).epsilon(0.001));
  CHECK(laid.layers.at(16).filament_mm == doctest::Approx(narrow).epsilon(0.001));
}

TEST_CASE("the floor is dense, whatever the heights of its layers") {
  const test::PartFolder folder;
  const std::string path = folder.add("box.stl", parts::box({0, 0, 0}, 20, 20, 3));
  for (const double first_mm : {0.2, 0.3, 0.35}) {
    CAPTURE(first_mm);
    core::Settings settings = vase_settings();
    settings.first_layer_height = Length::from_mm(first_mm);
    settings.loose_every_layers = 2;
    for (const auto& each : lay(settings, path).layers) {
      const LaidLayer& layer = each.second;
      if (layer.rises || layer.bottom == Length()) continue;
      CAPTURE(layer.top.mm());
      const double d = settings.filament_diameter.mm();
      const double mm3 = layer.filament_mm * std::numbers::pi * d * d / 4;
      CHECK(mm3 == doctest::Approx(20 * 20 * 0.2).epsilon(0.02));
    }
  }
}
