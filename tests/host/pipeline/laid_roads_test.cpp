#include "host/pipeline/laid_roads.h"

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "host/pipeline/pipeline.h"
#include "tests/host/print_rig.h"
#include "tests/support/part_folder.h"

using core::Point;
using core::Road;
using host::LaidRoads;
using host::LaidRoadsMemory;

TEST_CASE("layers of the same roads share what is known of them, others don't") {
  LaidRoadsMemory memory(2);
  const auto roads = [] { return std::make_shared<std::vector<Road>>(); };
  const LaidRoadsMemory::Roads even = roads(), odd = roads(), third = roads();
  const std::shared_ptr<LaidRoads> of_even = memory.of(even, nullptr);
  const std::shared_ptr<LaidRoads> of_odd = memory.of(odd, nullptr);
  CHECK_NE(of_even, of_odd);
  CHECK_EQ(memory.of(even, nullptr), of_even);
  CHECK_EQ(memory.of(odd, nullptr), of_odd);
  const core::SupportPlan supports;
  CHECK_NE(memory.of(odd, &supports), of_odd);
  CHECK_EQ(memory.of(odd, nullptr), of_odd);
  CHECK_NE(memory.of(third, nullptr), of_even);  // takes its place
  CHECK_NE(memory.of(even, nullptr), of_even);
}

TEST_CASE("every layer's motions are those of its own roads, also where layers share them") {
  const test::PartFolder folder;
  const std::string path = folder.add("box.stl", parts::box({0, 0, 0}, 14, 9, 5));
  const core::Settings settings;
  for (const int threads : {1, 3}) {
    CAPTURE(threads);
    host::PrintPlan print_plan = print_test::open(settings, path);
    print_plan.threads = threads;
    std::vector<Point> starts;
    std::size_t begun = 0, layers = 0, wrong = 0;
    Point at;
    host::PipelineOutputs outputs;
    outputs.on_roads = [&](const core::SplitLayer&, const std::vector<Road>& roads) {
      wrong += begun == starts.size() ? 0 : 1;
      starts.clear();
      begun = 0;
      for (const Road& road : roads) starts.push_back(road.points.front());
      ++layers;
      return true;
    };
    outputs.on_motion = [&](const core::Motion& motion, const auto&) {
      if (const auto* travel = std::get_if<core::Travel>(&motion)) at = travel->to;
      if (const auto* line = std::get_if<core::Extrude>(&motion)) at = line->to;
      if (const auto* arc = std::get_if<core::ExtrudeArc>(&motion)) at = arc->to;
      if (std::holds_alternative<core::RoadStart>(motion)) {
        wrong += begun < starts.size() && starts[begun] == at ? 0 : 1;
        ++begun;
      }
      return true;
    };
    host::PipelineSignals signals;
    host::GeometryStatistics statistics;
    REQUIRE(host::run_pipeline(print_plan, outputs, signals, statistics).ok());
    CHECK_EQ(layers, 25);
    CHECK_EQ(wrong, 0);
    CHECK_GT(statistics.reused.roads, 5);
  }
}
