#include "firmware_link/virtual/virtual_port.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "firmware_link/wire/check.h"

namespace firmware_link {
namespace {

// How long a reader sleeps at most before it looks again.
constexpr Duration kNap = std::chrono::milliseconds(1);

}  // namespace

VirtualPort::VirtualPort(const VirtualControllerOptions& options, PortClock clock, double speed)
    : clock_(std::move(clock)),
      speed_(speed),
      origin_(clock_.now()),
      simulated_(origin_),
      controller_(options, origin_) {
  LINK_CHECK(clock_.now && clock_.sleep && speed >= 0);
}

// At speed 0 simulated time moves by jumps alone.
Instant VirtualPort::simulated_now() {
  if (speed_ > 0) {
    const double passed = static_cast<double>((clock_.now() - origin_).count()) * speed_;
    simulated_ = std::max(simulated_, origin_ + Duration(static_cast<Duration::rep>(passed)));
  }
  return simulated_;
}

std::size_t VirtualPort::write(std::span<const std::byte> bytes) {
  return controller_.input(bytes, simulated_now());
}

std::size_t VirtualPort::read(std::span<std::byte> into, int timeout_ms) {
  const Instant deadline = clock_.now() + std::chrono::milliseconds(timeout_ms);
  while (true) {
    controller_.advance(simulated_now());
    if (const std::size_t count = controller_.output(into); count > 0) return count;
    if (speed_ == 0 && controller_.owes_answer()) {
      if (const auto next = controller_.next_event()) {
        simulated_ = std::max(simulated_, *next);
        continue;
      }
    }
    const Instant now = clock_.now();
    if (now >= deadline) return 0;
    clock_.sleep(std::min(kNap, deadline - now));
  }
}

VirtualController& VirtualPort::controller() {
  controller_.advance(simulated_now());
  if (speed_ == 0) {
    while (controller_.moving() || controller_.owes_answer()) {
      const auto next = controller_.next_event();
      if (!next) break;
      simulated_ = std::max(simulated_, *next);
      controller_.advance(simulated_);
    }
  }
  return controller_;
}

}  // namespace firmware_link
