// A ready G-code file that is to be printed as it is: opened, and looked through.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/result.h"              // Result
#include "core/settings.h"            // Settings
#include "host/files/input_file.h"    // InputFile
#include "host/gcode/file_bytes.h"    // FileBytes
#include "host/gcode/gcode_text.h"    // GcodeText
#include "host/gcode/line_meaning.h"  // MeaningRules
#include "host/gcode/ready_scan.h"    // ReadySummary, ScanRequest

namespace host {

class ReadyFile {
 public:
  // `binary`: a bgcode file.
  ReadyFile(FileBytes bytes, bool binary) : bytes_(std::move(bytes)), binary_(binary) {}

  [[nodiscard]] const std::string& name() const { return bytes_.name(); }
  [[nodiscard]] std::int64_t size() const { return bytes_.size(); }

  // Its text, from the start; several may be read at a time. REQUIRES: this stays where it is.
  [[nodiscard]] std::unique_ptr<GcodeText> text() const;

  // Looks through all of it (ready_scan.h), and keeps the summary. Errors have the file's name.
  [[nodiscard]] core::Status scan(const core::Settings& settings, const ScanRequest& request);
  // REQUIRES: scan() was fine.
  [[nodiscard]] const ReadySummary& summary() const { return summary_; }

 private:
  FileBytes bytes_;
  bool binary_;
  ReadySummary summary_;
};

// Copies what comes through a pipe into a temporary file without a name, in `folder` (empty:
// $TMPDIR, or /tmp), because all of it is checked before any of it is printed. REQUIRES: only
// kind_of() has read `pipe`.
[[nodiscard]] core::Result<FileBytes> spooled(InputFile pipe, const std::string& folder);

}  // namespace host
