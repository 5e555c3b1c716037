#include "host/gcode/ready_file.h"

#include "host/files/spill_file.h"
#include "host/gcode/bgcode_text.h"

namespace host {

std::unique_ptr<GcodeText> ReadyFile::text() const {
  return binary_ ? bgcode_text(bytes_) : plain_text(bytes_);
}

core::Status ReadyFile::scan(const core::Settings& settings, const ScanRequest& request) {
  const std::unique_ptr<GcodeText> whole = text();
  core::Result<ReadySummary> summary = scan_ready(*whole, settings, request);
  if (!summary.ok()) {
    const core::Error& error = summary.error();
    if (error.message.starts_with(name())) return error;
    return core::Error{error.code, name() + ": " + error.message};
  }
  summary_ = std::move(summary).value();
  return {};
}

core::Result<FileBytes> spooled(InputFile pipe, const std::string& folder) {
  constexpr SpillUse kUse{"the G-code of a pipe",
                          "name another folder with --spool, or save the G-code as a file"};
  core::Result<SpillFile> spill = SpillFile::create(folder, kUse);
  if (!spill.ok()) return spill.error();
  while (true) {
    const core::Result<std::string_view> bytes = pipe.window(1);
    if (!bytes.ok()) return bytes.error();
    if (bytes.value().empty()) break;
    if (core::Status kept = spill.value().append(bytes.value()); !kept.ok()) return kept.error();
    pipe.skip(bytes.value().size());
  }
  return FileBytes::of_spill(pipe.name(), std::move(spill).value());
}

}  // namespace host
