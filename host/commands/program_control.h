// A print's control (print_control.h) as the program has it: signals, keys, the journal's keeper,
// the port by its USB device.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "firmware_link/ports/byte_port.h"  // BytePort
#include "host/commands/journal_keeper.h"   // JournalKeeper
#include "host/printing/controls.h"         // Controls
#include "host/printing/print_control.h"    // PrintControl
#include "host/printing/progress.h"         // Reporter
#include "host/printing/request_pipe.h"     // RequestPipe
#include "host/settings/options.h"          // Options

namespace host {

class ProgramControl final : public PrintControl {
 public:
  // All outlive it. `port`: the one that the print started with; it is closed before it is asked
  // for again. `usb`: of that port (usb_of); empty: it is known by its name alone.
  struct Parts {
    const Options& options;
    Controls& controls;
    JournalKeeper& keeper;
    std::unique_ptr<firmware_link::BytePort>& port;
    Reporter& reporter;
  };
  ProgramControl(const Parts& parts, std::string usb) : parts_(parts), usb_(std::move(usb)) {}

  [[nodiscard]] int stop_urgency() override;
  [[nodiscard]] std::optional<UserRequest> next_request() override;
  [[nodiscard]] std::optional<int> next_cancelled() override;
  [[nodiscard]] core::Status may_start() override;
  [[nodiscard]] Journal* journal() override;
  [[nodiscard]] std::unique_ptr<firmware_link::BytePort> reopen_port() override;
  // With --yes it is where it was sent to, unless that is in doubt.
  [[nodiscard]] std::optional<std::int64_t> nozzle_height(std::int64_t z_um,
                                                          bool in_doubt) override;

 private:
  // Requests that came over the pipe, sorted.
  void hear();

  Parts parts_;
  std::string usb_;
  std::unique_ptr<RequestPipe> pipe_;  // null: there is none
  std::optional<UserRequest> request_;
  std::optional<int> cancelled_;
};

// Asks a person where the nozzle is, in µm; nothing: nobody answered, or it is not safe. `z_um`:
// where it should be.
[[nodiscard]] std::optional<std::int64_t> ask_nozzle_height(Controls& controls, std::int64_t z_um);

}  // namespace host
