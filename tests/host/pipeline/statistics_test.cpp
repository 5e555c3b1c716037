#include "host/pipeline/statistics.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "host/system/limits.h"

using core::Length;
using nlohmann::json;

namespace {

core::Slice slice_with(std::int64_t layer, core::SliceDefects defects) {
  core::Slice slice;
  slice.index = layer;
  slice.height = Length::from_mm(0.2);
  slice.bottom = slice.height * layer;
  slice.defects = defects;
  return slice;
}

}  // namespace

TEST_CASE("defects are counted for ever and told by height a bounded number of times") {
  host::DefectLog log;
  CHECK_EQ(log.summary(), "");
  log.add(slice_with(0, {}));
  CHECK_EQ(log.layers(), 0);
  core::SliceDefects open;
  open.closed_chains = 2;
  open.widest_gap = Length::from_mm(0.25);
  for (std::int64_t layer = 1; layer <= 10'000; ++layer) log.add(slice_with(layer, open));
  CHECK_EQ(log.layers(), 10'000);
  CHECK_EQ(log.closed_chains(), 20'000);
  CHECK_EQ(log.heights().size(), host::kDefectHeightsMax);
  CHECK_EQ(log.heights().front(), Length::from_mm(0.4));
  CAPTURE(log.summary());
  CHECK_NE(log.summary().find("10000 layers"), std::string::npos);
  CHECK_NE(log.summary().find("20000 open contours closed (widest gap 0.25 mm)"),
           std::string::npos);
  CHECK_NE(log.summary().find("at height 0.4 0.6"), std::string::npos);
  CHECK_NE(log.summary().find("..."), std::string::npos);
}

TEST_CASE("allocations are counted by stage, the first layers left out") {
  host::AllocationLog log;
  CHECK_EQ(log.per_layer(host::Stage::kOffset), 0);
  host::StageCounts counts{};
  for (std::int64_t layer = 0; layer < host::kWarmUpLayers + 4; ++layer) {
    counts[static_cast<std::size_t>(host::Stage::kOffset)] =
        layer < host::kWarmUpLayers ? 1000 : layer;
    log.add(layer, counts);
  }
  CHECK_EQ(log.per_layer(host::Stage::kOffset), doctest::Approx(host::kWarmUpLayers + 1.5));
  CHECK_EQ(log.per_layer(host::Stage::kRoads), 0);
}

TEST_CASE("the statistics file has every key that was promised") {
  const host::GeometryStatistics geometry;
  host::LinkStatistics link;
  link.first_road_s = 1.5;
  const json with_link = json::parse(host::statistics_json(geometry, &link));
  for (const char* key : {"layers",
                          "peak_layers_held",
                          "peak_regions_held",
                          "peak_triangles_held",
                          "peak_rss_bytes",
                          "cpu_seconds",
                          "worst_layer_ms",
                          "first_command_s",
                          "first_road_s",
                          "slices_cut_at_first_road",
                          "spilled_bytes",
                          "bad_layers",
                          "filament_mm",
                          "time_s",
                          "allocations_per_layer",
                          "boolean_retries",
                          "pace",
                          "standing",
                          "stalls",
                          "resends",
                          "defects",
                          "hanging",
                          "slow_layers",
                          "geometry_ended"}) {
    CAPTURE(key);
    CHECK(with_link.contains(key));
  }
  for (const char* stage : {"read", "sort", "slice", "offset", "window", "roads", "seams", "lay",
                            "encode", "send", "open", "finish"}) {
    CAPTURE(stage);
    CHECK(with_link["cpu_seconds"].contains(stage));
    CHECK(with_link["worst_layer_ms"].contains(stage));
  }
  CHECK_EQ(with_link["first_road_s"], 1.5);
  CHECK(with_link["first_command_s"].is_null());
  CHECK_GT(with_link["peak_rss_bytes"], 100'000);
  host::GeometryStatistics written;
  written.first_road_s = 0.5;
  written.first_road_cpu_s = 0.25;
  const double start_s = host::process_cpu_seconds();
  written.ended_cpu_s = start_s - 3;
  const json without_link = json::parse(host::statistics_json(written, nullptr));
  CHECK_FALSE(without_link.contains("stalls"));
  CHECK_EQ(without_link["first_road_s"], 0.5);
  CHECK_EQ(without_link["first_road_cpu_s"], 0.25);
  const double finish_s = without_link["cpu_seconds"]["finish"];
  CHECK_GE(finish_s, 3);
  CHECK_LE(finish_s, 3 + host::process_cpu_seconds() - start_s);
  CHECK_EQ(json::parse(host::statistics_json(written, &link))["cpu_seconds"]["finish"], 0);
}

TEST_CASE("processor time goes to the stage that spent it") {
  host::StageClock clock;
  const auto work = [](double seconds) {
    const double until = host::thread_cpu_seconds() + seconds;
    while (host::thread_cpu_seconds() < until) continue;
  };
  clock.enter(host::Stage::kSlice);
  work(0.004);
  clock.enter(host::Stage::kRoads);
  work(0.012);
  clock.end_layer();
  work(0.002);
  clock.enter(host::Stage::kNone);
  clock.end_layer();
  CHECK_GE(clock.seconds(host::Stage::kSlice), 0.004);
  CHECK_GE(clock.seconds(host::Stage::kRoads), 0.014);
  CHECK_GE(clock.worst_layer_ms(host::Stage::kRoads), 12);
  CHECK_LT(clock.worst_layer_ms(host::Stage::kRoads), clock.seconds(host::Stage::kRoads) * 1e3);
  CHECK_EQ(clock.seconds(host::Stage::kSend), 0);
}
