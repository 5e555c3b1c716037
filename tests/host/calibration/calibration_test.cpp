// The bodies of `rind test`: where they lie, how high their blocks are, and which ranges are taken.
#include "host/calibration/calibration.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/settings/whole_settings.h"

using host::Calibration;
using host::CalibrationBlock;
using host::PrintSettings;

namespace {

PrintSettings settings_of(const std::string& preset, const std::string& filament = "pla",
                          const std::string& quality = "0.2") {
  host::SettingsRequest request;
  request.printer.preset = preset;
  request.printer.filament = filament;
  request.printer.quality = quality;
  const auto whole = host::whole_settings(request);
  REQUIRE(whole.ok());
  return whole.value().settings;
}

Calibration planned(const host::CalibrationRequest& request, const PrintSettings& settings) {
  auto calibration = host::plan_calibration(request, settings);
  if (!calibration.ok()) FAIL(calibration.error().message);
  return std::move(calibration).value();
}

std::string refused(const host::CalibrationRequest& request, const PrintSettings& settings) {
  const auto calibration = host::plan_calibration(request, settings);
  return calibration.ok() ? "" : calibration.error().message;
}

// Where the body lies on the bed, in mm: in its middle, or where it says.
std::pair<double, double> shift_of(const Calibration& calibration, const PrintSettings& settings) {
  const host::Span x = calibration.solid.extent(0), y = calibration.solid.extent(1);
  std::pair<double, double> shift{(settings.bed_x.mm() - x.from - x.to) / 2,
                                  (settings.bed_y.mm() - y.from - y.to) / 2};
  for (const auto& [key, value] : calibration.settings) {
    if (key == "part_x") shift.first = std::stod(value) - x.from;
    if (key == "part_y") shift.second = std::stod(value) - y.from;
  }
  return shift;
}

// Crossings of a ray to the right with the outline; a rectangle without one.
bool on_bed(double x, double y, const PrintSettings& settings) {
  if (x < 0 || y < 0 || x > settings.bed_x.mm() || y > settings.bed_y.mm()) return false;
  if (settings.bed_shape.empty()) return true;
  bool inside = false;
  const std::size_t count = settings.bed_shape.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto corner = [&](std::size_t k) {
      const core::Point at = settings.bed_shape[k % count];
      return std::pair{at.x * 1e-4 - settings.bed_origin_x.mm(),
                       at.y * 1e-4 - settings.bed_origin_y.mm()};
    };
    const auto [ax, ay] = corner(i);
    const auto [bx, by] = corner(i + 1);
    if ((ay > y) != (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)) inside = !inside;
  }
  return inside;
}

// Each edge is run both ways equally often, and the volume is positive.
void check_closed(const host::TestSolid& solid) {
  using Corner = host::TestSolid::Corner;
  std::map<std::pair<Corner, Corner>, int> edges;
  double volume = 0;
  for (const auto& facet : solid.facets()) {
    const auto& [a, b, c] = facet;
    volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
               a[2] * (b[0] * c[1] - b[1] * c[0])) /
              6;
    for (int i = 0; i < 3; ++i) {
      const Corner& from = facet[static_cast<std::size_t>(i)];
      const Corner& to = facet[static_cast<std::size_t>((i + 1) % 3)];
      ++edges[{from, to}];
      --edges[{to, from}];
    }
  }
  CHECK(volume > 1);
  int open = 0;
  for (const auto& [edge, balance] : edges) open += balance == 0 ? 0 : 1;
  CHECK_EQ(open, 0);
}

double millimetres_over(double mm, double unit_mm) {
  return std::abs(mm - std::round(mm / unit_mm) * unit_mm);
}

}  // namespace

TEST_CASE("bodies are closed, lie on the bed, and stay below the axis' end") {
  for (const std::string preset : {"ender3", "delta", "klipper", "duet", "mini", "voron02"}) {
    for (const std::string quality : {"0.1", "0.2", "0.3"}) {
      for (const std::string_view test : host::calibration_names()) {
        CAPTURE(preset);
        CAPTURE(quality);
        CAPTURE(std::string(test));
        const PrintSettings settings = settings_of(preset, "pla", quality);
        host::CalibrationRequest request{std::string(test), {}, {}, {}};
        // A small printer has no room for all blocks.
        if (preset == "voron02" && test == "max-flow") request.to = 15;
        const Calibration calibration = planned(request, settings);
        check_closed(calibration.solid);
        const auto [dx, dy] = shift_of(calibration, settings);
        int outside = 0;
        for (const auto& facet : calibration.solid.facets()) {
          for (const auto& corner : facet) {
            const bool within = on_bed(corner[0] + dx, corner[1] + dy, settings) &&
                                corner[2] >= 0 && corner[2] <= settings.axis_z.mm();
            outside += within ? 0 : 1;
          }
        }
        CHECK_EQ(outside, 0);
      }
    }
  }
}

TEST_CASE("the squares of the first layer reach into the corners, also of a round bed") {
  for (const std::string preset : {"ender3", "delta", "voron24-350"}) {
    CAPTURE(preset);
    const PrintSettings settings = settings_of(preset);
    const Calibration calibration = planned({"first-layer", {}, {}, {}}, settings);
    const auto [dx, dy] = shift_of(calibration, settings);
    const double x = settings.bed_x.mm(), y = settings.bed_y.mm();
    for (const host::Span extent : {calibration.solid.extent(0), calibration.solid.extent(1)}) {
      CHECK(extent.to - extent.from > 0.75 * std::min(x, y));
    }
    // One in each third of a third of the bed.
    std::set<std::pair<int, int>> thirds;
    for (const auto& facet : calibration.solid.facets()) {
      for (const auto& corner : facet) {
        thirds.insert({static_cast<int>((corner[0] + dx) / x * 3),
                       static_cast<int>((corner[1] + dy) / y * 3)});
      }
    }
    CHECK_EQ(thirds.size(), 9);
  }
}

TEST_CASE("blocks are whole layers on one another, and nothing ends within a layer") {
  for (const std::string quality : {"0.1", "0.2", "0.3"}) {
    PrintSettings settings = settings_of("ender3", "pla", quality);
    settings.first_layer_height = core::Length::from_mm(0.25);
    const double layer = settings.layer_height.mm();
    for (const std::string test : {"temperature-tower", "retraction", "pressure-advance"}) {
      CAPTURE(quality);
      CAPTURE(test);
      const Calibration calibration = planned({test, {}, {}, {}}, settings);
      REQUIRE(calibration.blocks.size() >= 8);
      core::Length at = calibration.blocks.front().bottom;
      for (const CalibrationBlock& block : calibration.blocks) {
        CHECK_EQ(block.bottom, at);
        CHECK(block.top > block.bottom);
        CHECK(millimetres_over(block.bottom.mm() - 0.25, layer) < 1e-9);
        at = block.top;
      }
      int within = 0;
      for (const auto& facet : calibration.solid.facets()) {
        const bool level = facet[0][2] == facet[1][2] && facet[1][2] == facet[2][2];
        // Overhangs end where their angle says.
        if (!level || facet[0][2] == 0 || test == std::string("temperature-tower")) continue;
        within += millimetres_over(facet[0][2] - 0.25, layer) < 1e-9 ? 0 : 1;
      }
      CHECK_EQ(within, 0);
      const std::string text = host::calibration_text(calibration, test);
      CHECK_EQ(calibration.at_height.size(), calibration.blocks.size());
      CHECK_NE(text.find("look for"), std::string::npos);
      CHECK_NE(text.find(calibration.key + " to"), std::string::npos);
    }
  }
}

TEST_CASE("values follow the filament and the printer, or what was asked for") {
  const auto values = [](const host::CalibrationRequest& request, const PrintSettings& settings) {
    std::vector<double> all;
    for (const CalibrationBlock& block : planned(request, settings).blocks)
      all.push_back(block.value);
    return all;
  };
  using Values = std::vector<double>;
  CHECK_EQ(values({"temperature-tower", {}, {}, {}}, settings_of("ender3", "petg")),
           Values{255, 250, 245, 240, 235, 230, 225, 220});
  CHECK_EQ(values({"retraction", {}, {}, {}}, settings_of("ender3")),
           Values{1, 2, 3, 4, 5, 6, 7, 8, 9});
  CHECK_EQ(values({"retraction", {}, {}, {}}, settings_of("mk3s")).front(), 0);
  CHECK_EQ(values({"pressure-advance", {}, {}, {}}, settings_of("mk3s")).back(), 0.1);
  CHECK_EQ(values({"pressure-advance", {}, {}, {}}, settings_of("ender3")).back(), 1);
  CHECK_EQ(values({"max-flow", {}, {}, {}}, settings_of("ender3", "tpu")).front(), 1.25);
  CHECK_EQ(values({"retraction", 0.2, 0.65, 0.15}, settings_of("mk3s")),
           Values{0.2, 0.35, 0.5, 0.65});
  CHECK_EQ(values({"temperature-tower", 200, 190, 4}, settings_of("mk3s")), Values{200, 196, 192});
  // One end beyond the other usual one moves it.
  CHECK_EQ(values({"retraction", 10, {}, 4}, settings_of("ender3")), Values{10, 14, 18});
}

TEST_CASE("a printer that keeps the last pressure advance is told of") {
  PrintSettings settings = settings_of("ender3");
  const auto lines = [&] {
    return planned({"pressure-advance", {}, {}, {}}, settings).advice.size();
  };
  settings.pressure_advance_s = -1;
  const std::size_t kept = lines();
  settings.pressure_advance_s = 0.04;
  CHECK_EQ(kept, lines() + 1);
}

TEST_CASE("what can't be printed is refused, with the reason") {
  const PrintSettings settings = settings_of("ender3");
  const auto says = [&](const host::CalibrationRequest& request, const char* words) {
    const std::string message = refused(request, settings);
    CAPTURE(message);
    CHECK_NE(message.find(words), std::string::npos);
  };
  says({"temperature-tower", 120, {}, {}}, "from 150 to 350 °C");
  says({"temperature-tower", 220, 221, 5}, "one value alone");
  says({"temperature-tower", 220, 180, 0.5}, "81 values, more than 40");
  says({"temperature-tower", 340, 160, 5}, "axis_z is 250 mm");
  says({"temperature-tower", {}, {}, 0}, "the smallest step");
  says({"retraction", {}, 25, {}}, "from 0 to 20 mm");
  says({"max-flow", 20, 90, 10}, "mm/s with roads of 0.6 by 0.28 mm");
  says({"flow", 1, {}, {}}, "tries no range");
  says({"first-layer", {}, 1, {}}, "tries no range");
  says({"nothing", {}, {}, {}}, "there is no test");
  PrintSettings small;
  small.bed_x = small.bed_y = core::Length::from_mm(45);
  CHECK_NE(refused({"flow", {}, {}, {}}, small).find("too small"), std::string::npos);
  CHECK_NE(refused({"first-layer", {}, {}, {}}, small).find("too small"), std::string::npos);
}
