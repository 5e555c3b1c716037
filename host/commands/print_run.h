// What `print` and `resume` do in common, once the job is known: port, journal, keys, the print
// itself, and what is told in the end.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "firmware_link/byte_port.h"  // BytePort
#include "host/part/content_hash.h"   // FileContent
#include "host/pipeline/pipeline.h"   // Job
#include "host/printing/controls.h"   // Controls
#include "host/printing/journal.h"    // Journal, JournalHead
#include "host/printing/monitor.h"    // Resumption
#include "host/printing/progress.h"   // Reporter
#include "host/settings/options.h"    // Options

namespace host {

// The journal of one print: made when the part has been read, and with it what tells the part.
class JournalKeeper {
 public:
  // None is kept.
  JournalKeeper() = default;

  // Makes sure that the journal can be written, before anything moves.
  [[nodiscard]] core::Status plan(const std::string& path, JournalHead head);
  // From any thread: the part has been read, this is its content.
  void part_known(const FileContent& content);
  void take_up(Journal journal) {
    path_ = journal.path();
    journal_.emplace(std::move(journal));
  }

  // Null as long as there is none.
  [[nodiscard]] Journal* journal();
  // Where it is; empty: none is kept.
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
  JournalHead head_;
  std::mutex mutex_;
  std::optional<FileContent> content_;  // by mutex_
  bool made_ = false;
  std::optional<Journal> journal_;
};

// Which USB device a port is, as `rind ports` tells; empty: none, or not known.
[[nodiscard]] std::string usb_of(const std::string& port);

// How long a usual move's line is on its way through a serial port at that baud, with a little to
// spare; 0 where the baud does not say how fast it is: USB devices of their own kind (ttyACM),
// pseudo-terminals, networks, the virtual controller.
[[nodiscard]] double line_time_ms(const std::string& port, int baud);

// REQUIRES: options.port is not empty.
[[nodiscard]] int run_print(const Options& options, Job& job, JournalKeeper& keeper,
                            std::optional<Resumption> resumption, const std::string& usb,
                            double began_s, Reporter& reporter);

// Asks where the nozzle is; nothing: nobody answered, or it is not safe. `z_um`: where it should
// be. The height is in µm.
[[nodiscard]] std::optional<std::int64_t> ask_nozzle_height(Controls& controls, std::int64_t z_um);

}  // namespace host
