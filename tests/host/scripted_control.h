// A print's control (host/printing/print_control.h) whose answers a test writes down; what it
// leaves out is as in NullPrintControl.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "host/printing/print_control.h"

namespace print_test {

class ScriptedControl final : public host::NullPrintControl {
 public:
  std::function<int()> stop;
  std::function<std::optional<host::UserRequest>()> request;
  std::function<std::optional<int>()> cancelled;
  host::Journal* kept_journal = nullptr;
  std::function<std::unique_ptr<firmware_link::BytePort>()> reopen;
  std::function<std::optional<std::int64_t>(std::int64_t z_um)> height;

  [[nodiscard]] int stop_urgency() override { return stop ? stop() : 0; }
  [[nodiscard]] std::optional<host::UserRequest> next_request() override {
    return request ? request() : std::nullopt;
  }
  [[nodiscard]] std::optional<int> next_cancelled() override {
    return cancelled ? cancelled() : std::nullopt;
  }
  [[nodiscard]] host::Journal* journal() override { return kept_journal; }
  [[nodiscard]] std::unique_ptr<firmware_link::BytePort> reopen_port() override {
    return reopen ? reopen() : nullptr;
  }
  [[nodiscard]] std::optional<std::int64_t> nozzle_height(std::int64_t z_um, bool) override {
    return height ? height(z_um) : std::nullopt;
  }
};

}  // namespace print_test
