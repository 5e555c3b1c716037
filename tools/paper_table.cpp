// Plans the two test parts of DETC2000/DAC-14285 (figures 15 and 17) in the paper's three styles,
// and prints time and material beside the paper's figures.
//
//     paper_table [--loose-density SHARE]
//
// The paper gives neither dimensions nor settings. Assumed here:
//
//     pyramid   100 × 60 mm, 8 mm high, its right face rises at 5.2°. Chosen because its volume,
//               16.0 cm³, is that of the paper's 252 in of filament (15.9 cm³)
//     screw     44 mm across, thread 6 mm, flanks at 25.6°, 48 mm long, without a head. Its volume
//               is that of 872 in of filament (55 cm³). Its thickness is not known; the second
//               table has slimmer screws of the same volume
//     machine   an FDM 1650: layers of 0.254 mm (0.010 in), roads of 0.508 mm (0.020 in), filament
//               of 1.778 mm (0.070 in); every road at 20 mm/s, which is close to the paper's rate
//     wall      the paper's cylinder, T layers, one perimeter
//
// Two more insides hold up their roof by themselves: an empty one whose wall is a cone
// (loose_roof = cone, loose_density = 0), and a lightning fill.
//
// The density of the paper's loose fill is not known either. The second table shows how the ratios
// of dense to thin-wall depend on the dimensions: larger parts save more.
#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "core/settings.h"
#include "host/part/part_file.h"
#include "host/pipeline/pipeline.h"
#include "host/pipeline/statistics.h"
#include "host/settings/settings_table.h"
#include "tools/parts/part_maker.h"

namespace {

using core::BuildStyle;
using core::Length;

constexpr double kMmPerInch = 25.4;

struct Cost {
  double minutes = 0;
  double inches = 0;  // of filament
};

// The paper's measurements. For the fast style it only says "no slices found".
struct PaperPart {
  std::string name;
  parts::Part part;
  int wall_layers = 0;
  Cost regular;
  Cost thin_wall;
};

PaperPart pyramid(double height_mm) {
  return {"pyramid", parts::pyramid(height_mm), 3, {131, 252}, {110, 203}};
}

PaperPart screw(double diameter_mm, int turns) {
  return {"screw", parts::set_screw(diameter_mm, turns), 5, {504, 872}, {232, 301}};
}

core::Settings machine(int wall_layers, BuildStyle style, double loose_density) {
  core::Settings settings;
  settings.layer_height = Length::from_mm(0.254);
  settings.road_width = Length::from_mm(0.508);
  settings.filament_diameter = Length::from_mm(1.778);
  settings.wall_shape = core::WallShape::kCylinder;
  settings.wall_layers = wall_layers;
  settings.wall_thickness = settings.layer_height * wall_layers;
  settings.style = style;
  settings.perimeters = 1;
  settings.loose_density = loose_density;
  settings.skirt_loops = 0;
  settings.layer_time_min_s = 0;
  settings.retraction_mm = 0;
  for (double* speed : {&settings.perimeter_speed_mm_s, &settings.outer_perimeter_speed_mm_s,
                        &settings.solid_speed_mm_s, &settings.loose_speed_mm_s,
                        &settings.rest_speed_mm_s, &settings.first_layer_speed_mm_s}) {
    *speed = 20;
  }
  return settings;
}

[[noreturn]] void give_up(const std::string& message) {
  fmt::print(stderr, "paper_table: {}\n", message);
  std::exit(1);
}

// A file for one part, deleted with the object.
class PartOnDisk {
 public:
  explicit PartOnDisk(const parts::Part& part) {
    std::string pattern = (std::filesystem::temp_directory_path() / "paper_table_XXXXXX").string();
    const int file = ::mkstemp(pattern.data());
    if (file < 0) give_up(pattern + ": can't be written");
    ::close(file);
    path_ = pattern;
    std::ofstream out(path_, std::ios::binary);
    parts::write_binary_stl(part, out);
    if (!out.flush()) give_up(path_ + ": can't be written");
  }
  ~PartOnDisk() { std::remove(path_.c_str()); }
  PartOnDisk(const PartOnDisk&) = delete;
  PartOnDisk& operator=(const PartOnDisk&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

Cost build(const PartOnDisk& part, const core::Settings& settings) {
  if (core::Status status = host::validate_settings(settings); !status.ok()) {
    give_up(status.error().message);
  }
  core::Result<host::OpenedPart> opened = host::open_part(part.path(), settings);
  if (!opened.ok()) give_up(opened.error().message);
  host::PrintPlan plan{settings, std::move(opened).value(), part.path()};
  host::PipelineOutputs outputs;
  outputs.on_motion = [](const auto&, const auto&) { return true; };
  host::PipelineSignals signals;
  host::GeometryStatistics statistics;
  const auto end = host::run_pipeline(plan, outputs, signals, statistics);
  if (!end.ok()) give_up(end.error().message);
  return {statistics.time_s / 60, host::total_mm(statistics.filament_mm) / kMmPerInch};
}

core::Settings with_cone(core::Settings settings) {
  settings.loose_roof = core::LooseRoof::kCone;
  settings.loose_density = 0;
  return settings;
}

core::Settings with_lightning(core::Settings settings) {
  settings.loose_pattern = core::LoosePattern::kLightning;
  return settings;
}

void print_styles(const PaperPart& paper, double density) {
  const PartOnDisk part(paper.part);
  const auto in_style = [&](BuildStyle style) {
    return build(part, machine(paper.wall_layers, style, density));
  };
  const Cost thin = in_style(BuildStyle::kThinWall);
  const auto row = [&](const char* style, const Cost& ours, const Cost* theirs,
                       const char* none = "") {
    fmt::print("| {}, T = {} | {} | {:.0f} | {:.0f} | {:.2f} | {:.2f} |", paper.name,
               paper.wall_layers, style, ours.minutes, ours.inches, ours.minutes / thin.minutes,
               ours.inches / thin.inches);
    if (theirs == nullptr) {
      fmt::print(" {} | | | |\n", none);
      return;
    }
    fmt::print(" {:.0f} | {:.0f} | {:.2f} | {:.2f} |\n", theirs->minutes, theirs->inches,
               theirs->minutes / paper.thin_wall.minutes, theirs->inches / paper.thin_wall.inches);
  };
  row("regular", in_style(BuildStyle::kRegular), &paper.regular);
  row("fast", in_style(BuildStyle::kFast), nullptr, "no slice found");
  row("thin-wall", thin, &paper.thin_wall);
  const core::Settings settings = machine(paper.wall_layers, BuildStyle::kThinWall, density);
  row("cone, empty", build(part, with_cone(settings)), nullptr);
  row("lightning", build(part, with_lightning(settings)), nullptr);
}

void print_dimensions(const std::string& dimensions, const PaperPart& paper, double density) {
  const PartOnDisk part(paper.part);
  const Cost regular = build(part, machine(paper.wall_layers, BuildStyle::kRegular, density));
  const Cost thin = build(part, machine(paper.wall_layers, BuildStyle::kThinWall, density));
  fmt::print("| {} | {} | {:.0f} | {:.0f} | {:.2f} | {:.2f} |\n", paper.name, dimensions,
             regular.inches, thin.inches, regular.minutes / thin.minutes,
             regular.inches / thin.inches);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  double density = 0.2;
  CLI::App app{"The table of DETC2000/DAC-14285, by rind"};
  app.add_option("--loose-density", density, "share of the inside's volume")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  fmt::print("Ratios are over thin-wall. Loose density {:g}.\n\n", density);
  fmt::print("| part | style | min | in | time | material | paper: min | in | time | material |\n");
  fmt::print("| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  print_styles(pyramid(8), density);
  print_styles(screw(44, 8), density);

  fmt::print("\nRegular over thin-wall, by dimensions:\n\n");
  fmt::print("| part | dimensions | regular: in | thin-wall: in | time | material |\n");
  fmt::print("| --- | --- | ---: | ---: | ---: | ---: |\n");
  for (const double height : {4.0, 6.0, 8.0, 12.0, 20.0}) {
    print_dimensions(fmt::format("100 x 60 x {:g} mm", height), pyramid(height), density);
  }
  for (const auto& [diameter, turns] :
       {std::pair{28, 22}, {36, 13}, {44, 8}, {52, 6}, {60, 4}, {80, 8}}) {
    print_dimensions(fmt::format("{} mm across, {} mm long", diameter, 6 * turns),
                     screw(diameter, turns), density);
  }
}
