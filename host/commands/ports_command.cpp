#include <cstdio>
#include <nlohmann/json.hpp>

#include "firmware_link/ports.h"
#include "host/commands/commands.h"
#include "host/exit_codes.h"

namespace host {

int ports_command(const Options& options, Reporter&) {
  const std::vector<firmware_link::PortDescription> ports = firmware_link::list_ports();
  if (options.json) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const firmware_link::PortDescription& port : ports) {
      json.push_back({{"port", port.path}, {"description", port.description}, {"usb", port.usb}});
    }
    std::puts(json.dump(2).c_str());
    return kExitDone;
  }
  for (const firmware_link::PortDescription& port : ports) {
    std::printf("%-16s %s%s%s\n", port.path.c_str(), port.description.c_str(),
                port.usb.empty() ? "" : "  ", port.usb.c_str());
  }
  if (ports.empty()) std::puts("no serial port found");
  std::puts("virtual          a controller inside this program; nothing real is printed");
  return kExitDone;
}

}  // namespace host
