// A machine in the middle of a road, and commands as text.
#pragma once

#include <string>
#include <vector>

#include "firmware_link/wire/line_codec.h"  // encode
#include "host/printing/machine_state.h"

namespace print_test {

[[nodiscard]] inline std::vector<std::string> texts_of(
    const std::vector<firmware_link::Command>& commands) {
  std::vector<std::string> texts;
  for (const firmware_link::Command& command : commands) {
    firmware_link::TextBuffer buffer;
    texts.emplace_back(firmware_link::encode(command, buffer));
  }
  return texts;
}

[[nodiscard]] inline host::MachineState in_a_road() {
  host::MachineState state;
  state.x_um = 50'000;
  state.y_um = 60'500;
  state.z_um = 2'400;
  state.f_mm_min = 3'600;
  state.nozzle_tenths = 2'100;
  state.bed_tenths = 600;
  state.fan = 255;
  return state;
}

}  // namespace print_test
