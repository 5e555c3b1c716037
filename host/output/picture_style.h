// Common parts of the pictures: colours, legend rows, the scale bar, the page.
//
// Warm colours are dense, cool ones loose. The wall's three regions
// (core/sections/wall_regions.h) and the kinds of road have the same colours in every picture.
// Functions append to `svg`.
#pragma once

#include <array>
#include <string>

#include "core/roads/road.h"  // RoadKind
#include "core/settings.h"    // Settings
#include "core/units.h"       // Length

namespace host {

inline constexpr double kLegendRowPx = 26;
inline constexpr double kMarginPx = 36;
inline constexpr double kTitlePx = 84;  // title, subtitle and the space under them

struct Colours {
  const char* edge;  // the shaded sides of a bead, the outline of an area
  const char* body;
};

inline constexpr Colours kOwnColours = {"#c08a35", "#f0c47c"};
inline constexpr Colours kUncoveredColours = {"#a8492b", "#dd7d5b"};
inline constexpr Colours kNeighbourColours = {"#7f8a2f", "#b9c46a"};
inline constexpr Colours kFurtherColours = {"#7a5583", "#b795bf"};
inline constexpr Colours kLooseColours = {"#9dbac4", "#dde9ee"};
inline constexpr const char* kInkColour = "#3a2c14";

struct KindStyle {
  core::RoadKind kind;
  const char* name;
  Colours colours;
};

// In the order of the legend.
inline constexpr std::array<KindStyle, core::kRoadKindCount> kKindStyles = {{
    {core::RoadKind::kOuterPerimeter, "outer perimeter", {"#7d2a17", "#c8502f"}},
    {core::RoadKind::kOverhangPerimeter, "overhang perimeter", {"#1f3f8a", "#4f78d8"}},
    {core::RoadKind::kPerimeter, "perimeter", {"#a3541f", "#e58a45"}},
    {core::RoadKind::kTopSolid, "top", {"#8f2f4f", "#d9668c"}},
    {core::RoadKind::kBottomSolid, "bottom", {"#5f6420", "#a9b04a"}},
    {core::RoadKind::kSolid, "solid fill", {"#b27d22", "#f0bd5c"}},
    {core::RoadKind::kGapFill, "gap fill", {"#56306f", "#9a6bb8"}},
    {core::RoadKind::kBridge, "bridge", {"#0f4f4a", "#2fa79c"}},
    {core::RoadKind::kInternalBridge, "bridge over loose", {"#2f6b4a", "#72bf95"}},
    {core::RoadKind::kLoose, "loose fill", {"#2c5d72", "#5f9bb3"}},
    {core::RoadKind::kIroning, "ironing", {"#6d5a6d", "#b79fb7"}},
    {core::RoadKind::kRaft, "raft", {"#4f6b3a", "#8fb072"}},
    {core::RoadKind::kSupport, "support", {"#3d5a2a", "#7fa35f"}},
    {core::RoadKind::kSupportInterface, "support interface", {"#27421f", "#5f8a4a"}},
    {core::RoadKind::kBrim, "brim", {"#77776a", "#aeae9d"}},
    {core::RoadKind::kSkirt, "skirt", {"#8d8d8d", "#bdbdbd"}},
}};

// The colours of what is solid for another reason than the three regions; with the styles regular
// and fast, that is everything solid.
[[nodiscard]] const Colours& further_colours(const core::Settings& settings);

[[nodiscard]] const KindStyle& style_of(core::RoadKind kind);

[[nodiscard]] double to_mm(std::int64_t units);

// "wall 0.8 mm thick, by a ball"; for the styles regular and fast, the style.
[[nodiscard]] std::string wall_words(const core::Settings& settings);

// For legends: why each of the wall's regions is wall.
struct RegionWords {
  std::string own, uncovered, neighbours, further, loose;
};
[[nodiscard]] RegionWords region_words(const core::Settings& settings);

// Text, escaped for SVG.
[[nodiscard]] std::string escaped(const std::string& text);

// A page taller than `shown_height_max` is scaled down, for programs with a limit.
void start_page(std::string& svg, double width, double height, double shown_height_max = 1e9);
void end_page(std::string& svg);
void append_title(std::string& svg, const std::string& title, const std::string& subtitle);
void append_text(std::string& svg, double x, double y, const std::string& text);
void append_legend_row(std::string& svg, double x, double y, const Colours& colours,
                       const std::string& text);

// The largest of 1, 2, 5, 10 … mm that takes at most `most_px`.
[[nodiscard]] double scale_bar_mm(double px_per_mm, double most_px);
void append_scale_bar(std::string& svg, double x, double y, double px_per_mm, double most_px);

}  // namespace host
