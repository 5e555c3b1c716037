#include "firmware_link/ports/serial_port.h"

#include <libserialport.h>
#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <utility>

#include "firmware_link/wire/check.h"

namespace firmware_link {
namespace {

std::string text_or_empty(const char* text) { return text == nullptr ? "" : text; }

std::string usb_name(const sp_port* port) {
  if (sp_get_port_transport(port) != SP_TRANSPORT_USB) return {};
  std::string name;
  int vendor = 0;
  int product = 0;
  if (sp_get_port_usb_vid_pid(port, &vendor, &product) == SP_OK) {
    char numbers[16];
    std::snprintf(numbers, sizeof numbers, "%04x:%04x", static_cast<unsigned>(vendor) & 0xffffU,
                  static_cast<unsigned>(product) & 0xffffU);
    name = numbers;
  }
  for (const char* part : {sp_get_port_usb_manufacturer(port), sp_get_port_usb_product(port)}) {
    const std::string text = text_or_empty(part);
    if (!text.empty()) name += (name.empty() ? "" : " ") + text;
  }
  const std::string serial = text_or_empty(sp_get_port_usb_serial(port));
  if (!serial.empty()) name += ", serial " + serial;
  return name;
}

PortError last_error(const std::string& what, const std::string& remedy) {
  char* message = sp_last_error_message();
  PortError error{what + ": " + text_or_empty(message), remedy};
  sp_free_error_message(message);
  return error;
}

}  // namespace

struct SerialPort::Device {
  sp_port* port = nullptr;
  bool open = false;

  // A device that was pulled out reads as nothing, for ever.
  [[nodiscard]] bool hung_up() const {
    pollfd look{};
    if (sp_get_port_handle(port, &look.fd) != SP_OK) return false;
    return ::poll(&look, 1, 0) > 0 && (look.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
  }

  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  ~Device() {
    if (open) sp_close(port);
    sp_free_port(port);
  }
};

SerialPort::SerialPort(std::unique_ptr<Device> device) : device_(std::move(device)) {}
SerialPort::~SerialPort() = default;

std::variant<std::unique_ptr<BytePort>, PortError> SerialPort::open(const std::string& path,
                                                                    int baud) {
  LINK_CHECK(baud > 0);
  auto device = std::make_unique<Device>();
  if (sp_get_port_by_name(path.c_str(), &device->port) != SP_OK) {
    return PortError{path + " is not a serial port", "`rind ports` lists those that there are"};
  }
  if (sp_open(device->port, SP_MODE_READ_WRITE) != SP_OK) return open_error(path, errno);
  device->open = true;
  int file = -1;
  if (sp_get_port_handle(device->port, &file) == SP_OK && !claim(file)) {
    return open_error(path, EBUSY);
  }
  if (sp_set_bits(device->port, 8) != SP_OK ||
      sp_set_parity(device->port, SP_PARITY_NONE) != SP_OK ||
      sp_set_stopbits(device->port, 1) != SP_OK ||
      sp_set_flowcontrol(device->port, SP_FLOWCONTROL_NONE) != SP_OK) {
    return last_error(path + " cannot be set to 8 bits without parity",
                      "is it really a printer's port?");
  }
  if (sp_set_baudrate(device->port, baud) != SP_OK) {
    return last_error(path + " cannot run at " + std::to_string(baud) + " baud",
                      "name the controller's baud with --baud: 115200 and 250000 are usual");
  }
  return std::unique_ptr<BytePort>(new SerialPort(std::move(device)));
}

std::size_t SerialPort::write(std::span<const std::byte> bytes) {
  if (state_ == PortState::kLost || bytes.empty()) return 0;
  const int count = sp_nonblocking_write(device_->port, bytes.data(), bytes.size());
  if (count < 0) state_ = PortState::kLost;
  return static_cast<std::size_t>(std::max(0, count));
}

std::size_t SerialPort::read(std::span<std::byte> into, int timeout_ms) {
  if (state_ == PortState::kLost || into.empty()) return 0;
  // 0 would mean for ever to libserialport.
  const int count =
      timeout_ms <= 0
          ? static_cast<int>(sp_nonblocking_read(device_->port, into.data(), into.size()))
          : static_cast<int>(sp_blocking_read_next(device_->port, into.data(), into.size(),
                                                   static_cast<unsigned>(timeout_ms)));
  if (count < 0 || (count == 0 && device_->hung_up())) state_ = PortState::kLost;
  return static_cast<std::size_t>(std::max(0, count));
}

// Boards reset where DTR comes on: it goes off first, for as long as a driver needs to see it.
bool SerialPort::reset_device() {
  constexpr int kOff_ms = 60;
  if (sp_set_dtr(device_->port, SP_DTR_OFF) != SP_OK) return false;
  (void)::poll(nullptr, 0, kOff_ms);
  return sp_set_dtr(device_->port, SP_DTR_ON) == SP_OK;
}

std::vector<PortDescription> SerialPort::list() {
  std::vector<PortDescription> found;
  sp_port** ports = nullptr;
  if (sp_list_ports(&ports) != SP_OK) return found;
  for (std::size_t i = 0; ports[i] != nullptr; ++i) {
    found.push_back({text_or_empty(sp_get_port_name(ports[i])),
                     text_or_empty(sp_get_port_description(ports[i])), usb_name(ports[i])});
  }
  sp_free_port_list(ports);
  std::sort(found.begin(), found.end(),
            [](const PortDescription& a, const PortDescription& b) { return a.path < b.path; });
  return found;
}

}  // namespace firmware_link
