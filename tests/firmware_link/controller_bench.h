// A virtual controller to talk to by hand, in simulated time.
#pragma once

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "firmware_link/virtual/virtual_controller.h"
#include "firmware_link/wire/line_codec.h"

namespace link_test {

using namespace firmware_link;

struct Bench {
  Instant now{};
  std::vector<std::string> executed;
  VirtualController controller;

  explicit Bench(VirtualControllerOptions options = {})
      : controller(with_sink(std::move(options)), Instant{}) {
    banner = hear();
  }

  VirtualControllerOptions with_sink(VirtualControllerOptions options) {
    options.executed = [this](const ExecutedCommand& command) {
      executed.emplace_back(command.text);
    };
    return options;
  }

  std::string hear() {
    controller.advance(now);
    std::string text;
    std::array<std::byte, 100> buffer;
    while (const std::size_t count = controller.output(buffer)) {
      for (std::size_t i = 0; i < count; ++i) text.push_back(static_cast<char>(buffer[i]));
    }
    return text;
  }

  void send(const std::string& text) {
    CHECK(controller.input(std::as_bytes(std::span(text.data(), text.size())), now) == text.size());
  }

  std::string say(const std::string& text) {
    send(text);
    return hear();
  }

  std::string pass(Duration duration) {
    now += duration;
    return hear();
  }

  std::string numbered(int number, const std::string& text) {
    LineBuffer buffer;
    return std::string(number_line(number, text, buffer)) + "\n";
  }

  std::string banner;
};

inline std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

}  // namespace link_test
