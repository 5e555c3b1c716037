// The port and the session over it. A lost port is opened again, and a controller that was reset or
// came back gets a new session.
#pragma once

#include <memory>
#include <string_view>

#include "firmware_link/ports/byte_port.h"    // BytePort
#include "firmware_link/session/link_step.h"  // Halt
#include "firmware_link/session/session.h"    // Session
#include "host/pipeline/print_settings.h"     // PrintSettings
#include "host/printing/print_control.h"      // PrintControl

namespace host {

class PrinterLink {
 public:
  struct Options {
    double banner_wait_s;  // how long a `start` is waited for
    bool count_filament;   // SessionOptions
  };
  // The port outlives the link.
  PrinterLink(const PrintSettings& settings, const Options& options, firmware_link::BytePort& port);

  // Forgets the session before. `ask_found_line`: the controller may live (SessionOptions).
  void start_session(bool ask_found_line);
  // REQUIRES: one was started.
  [[nodiscard]] firmware_link::Session& session() { return *session_; }
  [[nodiscard]] const firmware_link::Session& session() const { return *session_; }

  // Gives the print's next command, or one that is none of the print's (Session::insert).
  void take(const firmware_link::Command& command, firmware_link::Instant now);
  void insert(const firmware_link::Command& command, firmware_link::Instant now);
  // Whether anything was given, to any session: nothing was heated or moved before.
  [[nodiscard]] bool given() const { return given_; }

  // One turn: writes, waits kLinkWait_ms for answers, reads.
  void step(firmware_link::Instant now);

  [[nodiscard]] bool port_open() const;
  // Closes the port and asks for it; false: it is not there yet.
  [[nodiscard]] bool reopen_port(PrintControl& control);

  // --- ends ---

  // Writes what the session has left, for so long at most; false: it could not all be written.
  [[nodiscard]] bool flush(double limit_s);
  // Reads once.
  void hear();
  [[nodiscard]] firmware_link::Halt halt(double limit_s);

  // Past the session, which must have nothing in flight: waits until all that was accepted has
  // moved. False: that was not confirmed in time, or the user asks for more of a stop.
  [[nodiscard]] bool moves_ended(double limit_s, PrintControl& control);

 private:
  firmware_link::SessionOptions options_;
  firmware_link::BytePort* port_;
  std::unique_ptr<firmware_link::BytePort> reopened_;
  std::unique_ptr<firmware_link::Session> session_;
  bool given_ = false;
};

}  // namespace host
