// Opening and listing ports on this computer.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "firmware_link/ports/byte_port.h"  // BytePort

namespace firmware_link {

// Why a port could not be opened, in a sentence, and what the user can do about it.
struct PortError {
  std::string cause;
  std::string remedy;
};

// What a system's error number (errno) means for someone who wants to print.
[[nodiscard]] PortError open_error(const std::string& path, int system_error);

// What is wrong with a port's name, where that can be told without opening it; empty: nothing.
[[nodiscard]] std::string port_name_mistake(const std::string& path);

// Claims an opened device for this program (flock), until it is closed; false: another one has it,
// and its lines would come between ours. Programs that don't ask are not kept out.
[[nodiscard]] bool claim(int file);

using OpenedPort = std::variant<std::unique_ptr<BytePort>, PortError>;

// Opens a device by its path: tcp://host:port as a TcpPort, a pseudo-terminal (a path under
// /dev/pts or a link to one) as a TtyPort, anything else as a SerialPort. Opening a real port
// resets most 8-bit boards. REQUIRES: baud > 0; pseudo-terminals and networks have none and ignore
// it.
[[nodiscard]] OpenedPort open_port(const std::string& path, int baud);

struct PortDescription {
  std::string path;         // "/dev/ttyUSB0"
  std::string description;  // "USB Serial", what the driver says
  std::string usb;          // "1a86:7523 QinHeng CH340, serial 1234", empty when it isn't USB
};

[[nodiscard]] std::vector<PortDescription> list_ports();

}  // namespace firmware_link
