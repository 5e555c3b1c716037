#include "host/pipeline/statistics.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "host/system/limits.h"

namespace host {
namespace {

using Json = nlohmann::ordered_json;

template <typename T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json stage_seconds(const StageClock& clock) {
  Json json;
  for (std::size_t i = 1; i < kStageCount; ++i) {
    const Stage stage = static_cast<Stage>(i);
    json[std::string(stage_name(stage))] = clock.seconds(stage);
  }
  return json;
}

Json stage_worst(const StageClock& clock) {
  Json json;
  for (std::size_t i = 1; i < kStageCount; ++i) {
    const Stage stage = static_cast<Stage>(i);
    json[std::string(stage_name(stage))] = clock.worst_layer_ms(stage);
  }
  return json;
}

Json filament_json(const FilamentUse& filament) {
  Json json;
  for (std::size_t i = 0; i < filament.size(); ++i) {
    json[road_kind_name(static_cast<core::RoadKind>(i))] = filament[i];
  }
  json["total"] = total_mm(filament);
  return json;
}

Json defects_json(const DefectLog& defects) {
  std::vector<double> heights;
  for (const core::Length height : defects.heights()) heights.push_back(height.mm());
  return {{"layers", defects.layers()},
          {"closed_chains", defects.closed_chains()},
          {"wide_chains", defects.wide_chains()},
          {"dropped_chains", defects.dropped_chains()},
          {"flipped_facets", defects.flipped_facets()},
          {"doubled_facets", defects.doubled_facets()},
          {"turned_contours", defects.turned_contours()},
          {"widest_gap_mm", defects.widest_gap().mm()},
          {"heights_mm", heights}};
}

// `size`: its key in a spot.
Json hanging_kind_json(const HangingLog::Kind& found, const char* size) {
  const auto one = [size](const HangingSpot& spot) {
    return Json{{"layer", spot.layer + 1},
                {"height_mm", spot.height.mm()},
                {"x_mm", core::Length::from_units(spot.place.at.x).mm()},
                {"y_mm", core::Length::from_units(spot.place.at.y).mm()},
                {size, spot.place.size}};
  };
  Json first = Json::array();
  for (const HangingSpot& spot : found.first) first.push_back(one(spot));
  return {{"count", found.count},
          {"layers", found.layers},
          {"largest", found.count > 0 ? one(found.largest) : Json()},
          {"first", first}};
}

Json hanging_json(const HangingLog& hanging) {
  return {{"islands", hanging_kind_json(hanging.of(core::HangingKind::kIsland), "area_mm2")},
          {"long_bridges", hanging_kind_json(hanging.of(core::HangingKind::kSpan), "span_mm")},
          {"overhangs", hanging_kind_json(hanging.of(core::HangingKind::kOverhang), "area_mm2")}};
}

Json slow_layers_json(const SlowLayers& slow) {
  const auto one = [](const SlowLayer& layer) {
    return Json{{"layer", layer.layer + 1},
                {"height_mm", layer.height.mm()},
                {"edges", layer.size.edges},
                {"islands", layer.size.islands},
                {"seconds", layer.seconds}};
  };
  Json first = Json::array();
  for (const SlowLayer& layer : slow.first) first.push_back(one(layer));
  return {{"count", slow.count},
          {"slowest", slow.count > 0 ? one(slow.slowest) : Json()},
          {"first", first}};
}

Json pace_json(const LayerPace& pace) {
  const auto one = [](const std::optional<PacedLayer>& layer) {
    if (!layer) return Json();
    return Json{{"layer", layer->layer + 1},
                {"computing_s", layer->computing_s},
                {"printing_s", layer->printing_s}};
  };
  return {{"before_first_layer_s", pace.before_first_layer_s()},
          {"slowest", one(pace.slowest())},
          {"behind", pace.behind()},
          {"furthest_behind", one(pace.furthest_behind())}};
}

Json body_json(const std::optional<core::StandingBody>& body) {
  if (!body) return {};
  return {{"x_mm", core::Length::from_units(body->foot.at.x).mm()},
          {"y_mm", core::Length::from_units(body->foot.at.y).mm()},
          {"height_mm", body->height.mm()},
          {"foot_breadth_mm", body->foot.breadth_mm},
          {"foot_area_mm2", body->foot.area_mm2},
          {"slenderness", core::slenderness(body->foot, body->height.mm())},
          {"brim_mm", or_null(core::brim_that_holds_mm(body->foot, body->height.mm()))}};
}

Json column_json(const std::optional<core::ThinColumn>& column) {
  if (!column) return {};
  return {{"x_mm", core::Length::from_units(column->at.x).mm()},
          {"y_mm", core::Length::from_units(column->at.y).mm()},
          {"bottom_mm", column->bottom.mm()},
          {"top_mm", column->top.mm()},
          {"thickness_mm", column->thickness_mm},
          {"slenderness", column->slenderness}};
}

Json standing_json(const std::optional<core::StandingReport>& standing) {
  if (!standing) return {};
  return {{"slenderest", body_json(standing->slenderest)},
          {"loose_bodies", standing->loose_bodies},
          {"loosest", body_json(standing->loosest)},
          {"thin_columns", standing->thin_columns},
          {"thinnest", column_json(standing->thinnest)},
          {"islands_not_followed", standing->islands_not_followed}};
}

Json allocations_json(const AllocationLog& allocations) {
  Json json;
  for (const Stage stage : {Stage::kSlice, Stage::kOffset, Stage::kWindow, Stage::kRoads,
                            Stage::kSeams, Stage::kLay, Stage::kEncode}) {
    json[std::string(stage_name(stage))] = allocations.per_layer(stage);
  }
  return json;
}

}  // namespace

std::string road_kind_name(core::RoadKind kind) {
  switch (kind) {
    case core::RoadKind::kSkirt:
      return "skirt";
    case core::RoadKind::kOuterPerimeter:
      return "outer_perimeter";
    case core::RoadKind::kPerimeter:
      return "perimeter";
    case core::RoadKind::kSolid:
      return "solid";
    case core::RoadKind::kGapFill:
      return "rest";
    case core::RoadKind::kLoose:
      return "loose";
    case core::RoadKind::kBrim:
      return "brim";
    case core::RoadKind::kOverhangPerimeter:
      return "overhang_perimeter";
    case core::RoadKind::kTopSolid:
      return "top_solid";
    case core::RoadKind::kBottomSolid:
      return "bottom_solid";
    case core::RoadKind::kBridge:
      return "bridge";
    case core::RoadKind::kInternalBridge:
      return "internal_bridge";
    case core::RoadKind::kIroning:
      return "ironing";
    case core::RoadKind::kRaft:
      return "raft";
    case core::RoadKind::kSupport:
      return "support";
    case core::RoadKind::kSupportInterface:
      return "support_interface";
  }
  return "unknown";
}

void GeometryStatistics::add_window(std::int64_t layers_held, std::int64_t regions_held,
                                    const RegionOperations& operations) {
  peak_held.layers = std::max(peak_held.layers, layers_held);
  peak_held.regions = std::max(peak_held.regions, regions_held);
  region_operations.count += operations.count;
  region_operations.worst = std::max(region_operations.worst, operations.worst);
}

void GeometryStatistics::add_reused(const ReuseCounts& more) {
  reused.offsets += more.offsets;
  reused.splits += more.splits;
  reused.roads += more.roads;
}

void GeometryStatistics::add_volume(const core::SplitLayer& layer, double moved_mm3) {
  const double height_mm = layer.slice.height.mm();
  volumes.solid_mm3 += layer.solid.area_mm2() * height_mm;
  volumes.loose_mm3 += layer.loose.area_mm2() * height_mm;
  volumes.regularised_mm3 += moved_mm3;
}

double total_mm(const FilamentUse& filament) {
  return std::accumulate(filament.begin(), filament.end(), 0.0);
}

void DefectLog::add(const core::Slice& slice) {
  if (!slice.defects.any()) return;
  ++layers_;
  closed_chains_ += slice.defects.closed_chains;
  wide_chains_ += slice.defects.wide_chains;
  dropped_chains_ += slice.defects.dropped_chains;
  flipped_facets_ += slice.defects.flipped_facets;
  doubled_facets_ += slice.defects.doubled_facets;
  if (turned_contours_ == 0 && slice.defects.turned_at) {
    turned_at_ = *slice.defects.turned_at;
    turned_height_ = slice.top();
  }
  turned_contours_ += slice.defects.turned_contours;
  widest_gap_ = std::max(widest_gap_, slice.defects.widest_gap);
  if (heights_.size() < kDefectHeightsMax) heights_.push_back(slice.top());
}

std::string DefectLog::summary() const {
  if (layers_ == 0) return "";
  const auto counted = [](std::int64_t count, const char* what) {
    return fmt::format(" {} {}{},", count, what, count == 1 ? "" : "s");
  };
  std::string text = fmt::format("mended in {} layer{}:", layers_, layers_ == 1 ? "" : "s");
  if (closed_chains_ > 0) {
    text += counted(closed_chains_, "open contour");
    text.back() = ' ';
    text += fmt::format("closed (widest gap {} mm", widest_gap_.mm());
    if (wide_chains_ > 0) {
      text += fmt::format(
          "; {} of them wider than chain_gap_max, closed by a straight line because "
          "the rest of the contour leaves no other way",
          wide_chains_);
    }
    text += "),";
  }
  if (dropped_chains_ > 0) text += counted(dropped_chains_, "left-out open contour");
  if (flipped_facets_ > 0) text += counted(flipped_facets_, "flipped facet");
  if (doubled_facets_ > 0) text += counted(doubled_facets_, "doubled facet");
  if (turned_contours_ > 0) {
    text += counted(turned_contours_, "inside-out contour");
    text.back() = ' ';
    text += fmt::format("(first near {:g}, {:g} on the bed, {:g} mm high),",
                        core::Length::from_units(turned_at_.x).mm(),
                        core::Length::from_units(turned_at_.y).mm(), turned_height_.mm());
  }
  text.back() = ';';
  text += " at height";
  for (const core::Length height : heights_) text += fmt::format(" {}", height.mm());
  if (layers_ > static_cast<std::int64_t>(heights_.size())) text += " ...";
  return text + " mm";
}

void AllocationLog::add(std::int64_t layer, const StageCounts& counts) {
  if (layer < kWarmUpLayers) return;
  ++layers_;
  for (std::size_t i = 0; i < counts.size(); ++i) counts_[i] += counts[i];
}

double AllocationLog::per_layer(Stage stage) const {
  const auto count = static_cast<double>(counts_[static_cast<std::size_t>(stage)]);
  return layers_ > 0 ? count / static_cast<double>(layers_) : 0;
}

std::int64_t peak_rss_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::int64_t{usage.ru_maxrss} * 1'024;
}

std::string statistics_json(const GeometryStatistics& geometry, const LinkStatistics* link) {
  StageClock clock = geometry.clock;
  if (link != nullptr) {
    clock.merge(link->clock);
  } else if (geometry.ended_cpu_s) {
    clock.set_seconds(Stage::kFinish, process_cpu_seconds() - *geometry.ended_cpu_s);
  }
  Json json = {
      {"layers", geometry.layers},
      {"roads", geometry.roads},
      {"arcs", geometry.arcs},
      {"peak_layers_held", geometry.peak_held.layers},
      {"peak_regions_held", geometry.peak_held.regions},
      {"peak_triangles_held", geometry.peak_held.triangles},
      {"spilled_bytes", geometry.spilled_bytes},
      {"bad_layers", geometry.bad_layers},
      {"slow_layers", slow_layers_json(geometry.slow_layers)},
      {"mountain_retries", geometry.retries.mountains},
      {"boolean_retries", geometry.retries.booleans},
      {"region_operations", geometry.region_operations.count},
      {"region_operations_worst", geometry.region_operations.worst},
      {"layers_reused",
       {{"offsets", geometry.reused.offsets},
        {"splits", geometry.reused.splits},
        {"roads", geometry.reused.roads}}},
      {"peak_rss_bytes", peak_rss_bytes()},
      {"cpu_seconds", stage_seconds(clock)},
      {"worst_layer_ms", stage_worst(clock)},
      {"layer_ms",
       {{"median", geometry.layer_times.median_ms()},
        {"worst", geometry.layer_times.worst_ms()},
        {"worst_layer", geometry.layer_times.worst_layer() + 1}}},
      {"pace", pace_json(geometry.pace)},
      {"allocations_per_layer", allocations_json(geometry.allocations)},
      {"solid_mm3", geometry.volumes.solid_mm3},
      {"loose_mm3", geometry.volumes.loose_mm3},
      {"regularised_mm3", geometry.volumes.regularised_mm3},
      {"regularised_g", geometry.volumes.regularised_mm3 * geometry.volumes.filament_density_g_mm3},
      {"filament_mm", filament_json(geometry.filament_mm)},
      {"needed_mm", geometry.needed.mm},
      {"time_s", geometry.time_s},
      {"geometry_ended", geometry.ended},
      {"defects", defects_json(geometry.defects)},
      {"hanging", hanging_json(geometry.hanging)},
      {"standing", standing_json(geometry.standing)}};
  json["first_road_s"] = or_null(link != nullptr ? link->first_road_s : geometry.first_road_s);
  json["first_road_cpu_s"] =
      or_null(link != nullptr ? link->first_road_cpu_s : geometry.first_road_cpu_s);
  if (link != nullptr) {
    json["first_command_s"] = or_null(link->first_command_s);
    json["slices_cut_at_first_road"] = or_null(link->slices_cut_at_first_road);
    json["commands"] = link->commands;
    json["stalls"] = link->stalls;
    json["resends"] = link->resends;
    json["resend_ratio"] = link->resend_ratio;
    json["planner_low_s"] = link->planner_low_s;
    json["slowdowns"] = link->slowdowns;
    json["parks"] = link->parks;
    json["recoveries"] = link->recoveries;
  }
  return json.dump(2) + "\n";
}

}  // namespace host
