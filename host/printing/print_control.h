// What a running print asks of the program and the people around it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/result.h"                    // Status
#include "firmware_link/ports/byte_port.h"  // BytePort
#include "host/printing/controls.h"         // UserRequest
#include "host/printing/journal.h"          // Journal

namespace host {

// All calls come from the link's thread.
class PrintControl {
 public:
  virtual ~PrintControl() = default;

  // How urgent a stop is: 0 nobody asks for one, 1 a safe end, 2 a halt (stop_signals.h). Asked on
  // each turn of the link's loop.
  [[nodiscard]] virtual int stop_urgency() = 0;

  // The oldest request that was not taken yet. Never waits.
  [[nodiscard]] virtual std::optional<UserRequest> next_request() = 0;

  // The number of an object that is to be cancelled, from 1; likewise.
  [[nodiscard]] virtual std::optional<int> next_cancelled() = 0;

  // Asked once: the controller has said what it can do, and was given no command. An error ends the
  // print.
  [[nodiscard]] virtual core::Status may_start() = 0;

  // Null as long as there is none.
  [[nodiscard]] virtual Journal* journal() = 0;

  // Opens a port that was lost, under the name that it has now. Null: it is not there yet.
  [[nodiscard]] virtual std::unique_ptr<firmware_link::BytePort> reopen_port() = 0;

  // Asks how high the nozzle is, because the controller has forgotten it. It was sent to `z_um`;
  // `in_doubt`: it may not have arrived there. Nothing: nobody answers, and the print ends.
  [[nodiscard]] virtual std::optional<std::int64_t> nozzle_height(std::int64_t z_um,
                                                                  bool in_doubt) = 0;
};

// Never stops, has no requests, keeps no journal, opens no port, answers nothing.
class NullPrintControl : public PrintControl {
 public:
  [[nodiscard]] int stop_urgency() override { return 0; }
  [[nodiscard]] std::optional<UserRequest> next_request() override { return std::nullopt; }
  [[nodiscard]] std::optional<int> next_cancelled() override { return std::nullopt; }
  [[nodiscard]] core::Status may_start() override { return {}; }
  [[nodiscard]] Journal* journal() override { return nullptr; }
  [[nodiscard]] std::unique_ptr<firmware_link::BytePort> reopen_port() override { return nullptr; }
  [[nodiscard]] std::optional<std::int64_t> nozzle_height(std::int64_t, bool) override {
    return std::nullopt;
  }
};

}  // namespace host
