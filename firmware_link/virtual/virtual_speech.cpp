#include "firmware_link/virtual/virtual_speech.h"

#include <cmath>
#include <cstdio>

#include "firmware_link/virtual/virtual_texts.h"  // kBanner
#include "firmware_link/wire/check.h"

namespace firmware_link {
namespace {

// As printf; at most 255 characters.
template <typename... Values>
std::string formatted(const char* format, Values... values) {
  char text[256];
  const int size = std::snprintf(text, sizeof text, format, values...);
  LINK_CHECK(size >= 0 && static_cast<std::size_t>(size) < sizeof text);
  return {text, static_cast<std::size_t>(size)};
}

std::string marlin_identity(const VirtualControllerOptions& options) {
  std::string text(kFirmwareName);
  text += kCapabilitiesBefore;
  text += formatted("Cap:EMERGENCY_PARSER:%d\n", options.emergency_parser ? 1 : 0);
  text += kCapabilitiesBehind;
  text += formatted("Cap:MEATPACK:%d\nCap:CONFIG_EXPORT:0\n", options.meatpack ? 1 : 0);
  const double left = options.bed_origin_x_mm, right = left + options.bed_x_mm;
  const double front = options.bed_origin_y_mm, back = front + options.bed_y_mm;
  text += formatted(
      "area:{full:{min:{x:%.4f,y:%.4f,z:0.0000},max:{x:%.4f,y:%.4f,z:%.4f}},work:{min:{x:%.4f,"
      "y:%.4f,z:0.0000},max:{x:%.4f,y:%.4f,z:%.4f}}}\n",
      left, front, right, back, options.height_z_mm, left, front, right, back, options.height_z_mm);
  return text;
}

}  // namespace

std::string banner_of(VirtualDialect dialect) {
  switch (dialect) {
    case VirtualDialect::kMarlin:
      return std::string(kBanner);
    case VirtualDialect::kPrusa:
      return std::string(kPrusaBanner);
    case VirtualDialect::kKlipper:
    case VirtualDialect::kRepRap:
      return {};
  }
  return {};
}

std::string identity_of(const VirtualControllerOptions& options) {
  switch (options.dialect) {
    case VirtualDialect::kMarlin:
      return marlin_identity(options);
    case VirtualDialect::kPrusa:
      return std::string(kPrusaIdentity);
    case VirtualDialect::kRepRap:
      return std::string(kRepRapIdentity);
    case VirtualDialect::kKlipper:
      return {};  // it is in the `ok`
  }
  return {};
}

std::string unknown_command(VirtualDialect dialect, std::string_view text) {
  const std::string words(text);
  const std::string command = words.substr(0, words.find(' '));
  switch (dialect) {
    case VirtualDialect::kMarlin:
      return "echo:Unknown command: \"" + words + "\"\n";
    case VirtualDialect::kPrusa:
      return "echo:Unknown " + words.substr(0, 1) + " code: " + words + "\n";
    case VirtualDialect::kKlipper:
      return "// Unknown command:\"" + command + "\"\n";
    case VirtualDialect::kRepRap:
      return "Warning: " + command + ": Command is not supported\n";
  }
  return {};
}

std::string position_of(VirtualDialect dialect, const VirtualControllerState& at) {
  switch (dialect) {
    case VirtualDialect::kMarlin:
      return formatted("X:%.2f Y:%.2f Z:%.2f E:%.2f Count X:%lld Y:%lld Z:%lld\n", at.x_mm, at.y_mm,
                       at.z_mm, at.e_mm, std::llround(at.x_mm * 80), std::llround(at.y_mm * 80),
                       std::llround(at.z_mm * 400));
    case VirtualDialect::kPrusa:
      return formatted("X:%.2f Y:%.2f Z:%.2f E:%.2f Count X: %.2f Y:%.2f Z:%.2f E:%.2f\n", at.x_mm,
                       at.y_mm, at.z_mm, at.e_mm, at.x_mm, at.y_mm, at.z_mm, at.e_mm);
    case VirtualDialect::kKlipper:
      return formatted("X:%.3f Y:%.3f Z:%.3f E:%.3f\n", at.x_mm, at.y_mm, at.z_mm, at.e_mm);
    case VirtualDialect::kRepRap:
      return formatted("X:%.3f Y:%.3f Z:%.3f E:%.3f E0:%.1f Count %lld %lld %lld\n", at.x_mm,
                       at.y_mm, at.z_mm, at.e_mm, at.e_mm, std::llround(at.x_mm * 80),
                       std::llround(at.y_mm * 80), std::llround(at.z_mm * 400));
  }
  return {};
}

std::string cold_extrusion(VirtualDialect dialect) {
  switch (dialect) {
    case VirtualDialect::kMarlin:
    case VirtualDialect::kPrusa:
      return "echo: cold extrusion prevented\n";
    case VirtualDialect::kKlipper:
      return "!! Extrude below minimum temp\n";
    case VirtualDialect::kRepRap:
      return "Warning: Tool 0 was not driven because its heater temperatures were not high "
             "enough\n";
  }
  return {};
}

std::string temperatures_of(VirtualDialect dialect, const HeaterReport& t) {
  switch (dialect) {
    case VirtualDialect::kMarlin:
      return formatted(" T:%.2f /%.2f B:%.2f /%.2f @:%d B@:%d", t.nozzle_celsius, t.nozzle_target,
                       t.bed_celsius, t.bed_target, t.nozzle_power, t.bed_power);
    case VirtualDialect::kPrusa:
      return formatted(" T:%.1f /%.1f B:%.1f /%.1f T0:%.1f /%.1f @:%d B@:%d P:0.0 A:31.4",
                       t.nozzle_celsius, t.nozzle_target, t.bed_celsius, t.bed_target,
                       t.nozzle_celsius, t.nozzle_target, t.nozzle_power, t.bed_power);
    case VirtualDialect::kKlipper:
      return formatted(" B:%.1f /%.1f T0:%.1f /%.1f", t.bed_celsius, t.bed_target, t.nozzle_celsius,
                       t.nozzle_target);
    case VirtualDialect::kRepRap:
      return formatted(" T:%.1f /%.1f B:%.1f /%.1f", t.nozzle_celsius, t.nozzle_target,
                       t.bed_celsius, t.bed_target);
  }
  return {};
}

}  // namespace firmware_link
