#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "firmware_link/ports/ports.h"
#include "host/commands/commands.h"

namespace host {

int ports_command(const Options& options, Reporter& reporter) {
  const std::vector<firmware_link::PortDescription> ports = firmware_link::list_ports();
  if (options.json) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const firmware_link::PortDescription& port : ports) {
      json.push_back({{"port", port.path}, {"description", port.description}, {"usb", port.usb}});
    }
    return show_result(json.dump(2) + "\n", reporter);
  }
  std::string text;
  for (const firmware_link::PortDescription& port : ports) {
    text += fmt::format("{:<16} {}{}{}\n", port.path, port.description,
                        port.usb.empty() ? "" : "  ", port.usb);
  }
  if (ports.empty()) text += "no serial port found\n";
  text += "virtual          a controller inside this program; nothing real is printed\n";
  return show_result(text, reporter);
}

}  // namespace host
