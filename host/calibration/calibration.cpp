#include "host/calibration/calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <utility>

#include "core/bed.h"    // Bed
#include "core/units.h"  // kUnitsPerMm
#include "host/calibration/calibration_parts.h"
#include "host/presets/printer_file.h"  // printer_path

namespace host {
namespace {

using core::Result;

constexpr std::array<std::string_view, 6> kNames = {
    "first-layer", "temperature-tower", "retraction", "flow", "pressure-advance", "max-flow"};

constexpr std::size_t kTextColumns = 100;

core::Error bad(std::string message) { return {core::ErrorCode::kBadSetting, std::move(message)}; }

// What would change the body, or what its blocks are printed with.
const std::vector<std::pair<std::string, std::string>>& plain_settings() {
  static const std::vector<std::pair<std::string, std::string>> kPlain = {
      {"part_scale", "1"},
      {"part_rotation", "0"},
      {"part_mirror", "none"},
      {"part_units", "mm"},
      {"shrinkage_xy", "0"},
      {"shrinkage_z", "0"},
      {"adaptive_layer_height", "0"},
      {"height_range", ""},
      {"height_slowdown_from", "0"},
      {"height_slowdown_to", "off"},
      {"height_slowdown_speed", "100%"},
      {"height_slowdown_acceleration", "100%"},
      {"style", "thin-wall"},
      {"fuzzy_skin", "none"},
      {"raft_layers", "0"},
      {"supports", "off"},
      // What hangs is meant to.
      {"overhang_angle_degrees", "89"},
      {"bridge_max", "100"},
  };
  return kPlain;
}

Result<Calibration> body_of(const CalibrationRequest& request, const PrintSettings& settings) {
  const bool ranged = request.from || request.to || request.step;
  const bool varies = request.test != "first-layer" && request.test != "flow";
  if (ranged && !varies) {
    return bad("rind test " + request.test +
               " tries no range of values: leave out --from, --to and --step");
  }
  if (request.test == "first-layer") return first_layer_squares(settings);
  if (request.test == "temperature-tower") return temperature_tower(request, settings);
  if (request.test == "retraction") return retraction_towers(request, settings);
  if (request.test == "flow") return flow_box(settings);
  if (request.test == "pressure-advance") return pressure_advance_frame(request, settings);
  if (request.test == "max-flow") return max_flow_loop(request, settings);
  return bad("there is no test \"" + request.test + "\"");
}

// Whether the middle of the bed has room for it.
core::Status fits(const Calibration& calibration, const PrintSettings& settings) {
  const double high = calibration.solid.extent(2).to;
  if (settings.axis_z > core::Length() && high > settings.axis_z.mm()) {
    return bad(
        fmt::format("the test is {:.1f} mm high, but axis_z is {:g} mm: fewer values, by "
                    "--from, --to, --step",
                    high, settings.axis_z.mm()));
  }
  const auto& own = calibration.settings;
  const bool placed =
      std::any_of(own.begin(), own.end(), [](const auto& pair) { return pair.first == "part_x"; });
  if (placed) return {};
  const Span x = calibration.solid.extent(0), y = calibration.solid.extent(1);
  const double wide = x.to - x.from + 2 * margin_mm(settings);
  const double deep = y.to - y.from + 2 * margin_mm(settings);
  const auto at = [](core::Length bed, double mm) {
    return static_cast<std::int32_t>((bed.mm() / 2 + mm) * core::kUnitsPerMm);
  };
  const core::Box box{{at(settings.bed_x, -wide / 2), at(settings.bed_y, -deep / 2)},
                      {at(settings.bed_x, wide / 2), at(settings.bed_y, deep / 2)}};
  if (core::Bed(settings).holds(box)) return {};
  return bad(
      fmt::format("the bed of {:g} x {:g} mm is too small: the test needs {:.0f} x {:.0f} mm "
                  "in its middle, with skirt and brim",
                  settings.bed_x.mm(), settings.bed_y.mm(), wide, deep));
}

// "look for   …", with the next lines under its text.
std::string paragraph(std::string_view head, std::string_view text) {
  const std::string indent(11, ' ');
  std::string out = fmt::format("{:<11}", head);
  std::size_t column = indent.size();
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (column > indent.size() && column + 1 + word.size() > kTextColumns) {
      out += "\n" + indent;
      column = indent.size();
    }
    if (column > indent.size()) out += ' ', ++column;
    out += word;
    column += word.size();
  }
  return out + "\n";
}

}  // namespace

std::span<const std::string_view> calibration_names() { return kNames; }

Result<Calibration> plan_calibration(const CalibrationRequest& request,
                                     const PrintSettings& settings) {
  Result<Calibration> made = body_of(request, settings);
  if (!made.ok()) return made;
  Calibration& calibration = made.value();
  auto& own = calibration.settings;
  for (const auto& plain : plain_settings()) own.push_back(plain);
  const auto is = [](const char* key) {
    return [key](const auto& pair) { return pair.first == key; };
  };
  if (std::none_of(own.begin(), own.end(), is("spiral_vase"))) own.emplace_back("spiral_vase", "0");
  if (std::none_of(own.begin(), own.end(), is("centre"))) own.emplace_back("centre", "1");
  if (core::Status fitting = fits(calibration, settings); !fitting.ok()) return fitting.error();
  return made;
}

std::string calibration_text(const Calibration& calibration, const std::string& test) {
  const auto size = [&](std::size_t axis) {
    const Span extent = calibration.solid.extent(axis);
    return extent.to - extent.from;
  };
  std::string text = paragraph("test", fmt::format("{}: {}, {:.1f} x {:.1f} x {:.1f} mm", test,
                                                   calibration.what, size(0), size(1), size(2)));
  const auto out = std::back_inserter(text);
  if (!calibration.blocks.empty()) {
    fmt::format_to(out, "{:<11}{:>19}   {}\n", "varied", "height", calibration.key);
  }
  for (const CalibrationBlock& block : calibration.blocks) {
    fmt::format_to(out, "{:<11}{:7.2f} to {:5.2f} mm   {:g}{}{}\n", "", block.bottom.mm(),
                   block.top.mm(), block.value, calibration.unit.empty() ? "" : " ",
                   calibration.unit);
  }
  std::string_view head = "look for";
  for (const std::string& line : calibration.advice) {
    text += paragraph(head, line);
    head = "";
  }
  const std::string file = printer_folder().empty() ? "" : printer_path(kUsualPrinter);
  text += paragraph("keep it", fmt::format("by --set KEY=VALUE for one print; for all of them by "
                                           "KEY = VALUE below [rind] in the printer's file{}{}",
                                           file.empty() ? "" : ", ", file));
  return text;
}

}  // namespace host
