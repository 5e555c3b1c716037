#include "tools/faults/controller_time.h"

#include <array>
#include <chrono>
#include <string>
#include <utility>

namespace firmware_link {
namespace {

VirtualControllerOptions without_hindrance(VirtualControllerOptions options) {
  options.extrude_celsius_min = 0;
  options.klipper.homed = true;
  return options;
}

}  // namespace

ControllerTime::ControllerTime(VirtualControllerOptions options)
    : controller_(without_hindrance(std::move(options)), Instant{}) {
  (void)hears_ok();
}

bool ControllerTime::hears_ok() {
  std::array<std::byte, 256> buffer;
  bool ok = false;
  char before[2] = {'\n', '\n'};
  while (const std::size_t count = controller_.output(buffer)) {
    for (std::size_t i = 0; i < count; ++i) {
      const char c = static_cast<char>(buffer[i]);
      ok = ok || (before[0] == '\n' && before[1] == 'o' && c == 'k');
      before[0] = before[1];
      before[1] = c;
    }
  }
  return ok;
}

void ControllerTime::execute(std::string_view line) {
  line = line.substr(0, line.find(';'));
  while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.remove_suffix(1);
  if (line.empty()) return;
  const std::string text = std::string(line) + "\n";
  (void)controller_.input(std::as_bytes(std::span(text.data(), text.size())), now_);
  controller_.advance(now_);
  while (!hears_ok()) {
    const auto next = controller_.next_event();
    now_ = next && *next > now_ ? *next : now_ + std::chrono::milliseconds(1);
    controller_.advance(now_);
  }
}

double ControllerTime::seconds() {
  while (controller_.moving()) {
    now_ += std::chrono::seconds(1);
    controller_.advance(now_);
    (void)hears_ok();
  }
  return std::chrono::duration<double>(controller_.totals().planner_busy).count();
}

}  // namespace firmware_link
