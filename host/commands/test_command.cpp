// rind test: a part of the program's own, printed or written like any other.
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include "host/calibration/calibration.h"
#include "host/commands/commands.h"
#include "host/files/content_hash.h"  // hash_of
#include "host/files/input_file.h"
#include "host/printing/journal_directory.h"
#include "host/settings/settings_text.h"  // write_lines
#include "host/system/exit_codes.h"

namespace host {
namespace {

using core::Result;
using core::Status;

// The body as a file. A print that may be interrupted has a real one beside its journal, which
// `rind resume` reads again; its name tells its content, so that nothing else is replaced. Any
// other is in memory alone.
class BodyFile {
 public:
  BodyFile() = default;
  ~BodyFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    std::error_code ignored;
    if (!kept_.empty() && !needed()) std::filesystem::remove(kept_, ignored);
  }
  BodyFile(const BodyFile&) = delete;
  BodyFile& operator=(const BodyFile&) = delete;

  // `journal`: as it was named; empty: one in the usual directory.
  Status keep(const std::string& stl, const std::string& test, const std::string& journal) {
    journal_ = journal;
    std::error_code error;
    std::filesystem::path folder = std::filesystem::absolute(journal, error).parent_path();
    if (journal.empty()) {
      folder = journal_directory();
      std::filesystem::create_directories(folder, error);
      remove_old(folder);
    }
    const std::string path =
        (folder / fmt::format("test-{}-{:016x}.stl", test, hash_of(stl))).string();
    if (Status written = write_output(path, stl); !written.ok()) return written;
    kept_ = path;
    return {};
  }

  Status hold(const std::string& stl, const std::string& test) {
    descriptor_ = ::memfd_create(test.c_str(), MFD_CLOEXEC);
    std::size_t done = 0;
    while (descriptor_ >= 0 && done < stl.size()) {
      const ssize_t count = ::write(descriptor_, stl.data() + done, stl.size() - done);
      if (count <= 0) break;
      done += static_cast<std::size_t>(count);
    }
    if (done == stl.size()) return {};
    return core::Error{core::ErrorCode::kUnreadable, test + ": no memory for the test's body of " +
                                                         std::to_string(stl.size()) + " bytes"};
  }

  [[nodiscard]] std::string path() const {
    return kept_.empty() ? "/proc/self/fd/" + std::to_string(descriptor_) : kept_;
  }

 private:
  // Whether a journal is there with which it may be resumed.
  [[nodiscard]] bool needed() const {
    if (!journal_.empty()) return find_journal(journal_).has_value();
    return is_needed(find_journals(), kept_);
  }

  [[nodiscard]] static bool is_needed(const std::vector<FoundJournal>& journals,
                                      const std::string& path) {
    return std::any_of(journals.begin(), journals.end(),
                       [&](const FoundJournal& one) { return is_of_part(one, path); });
  }

  // Those of prints that were resumed and are done.
  static void remove_old(const std::filesystem::path& folder) {
    const std::vector<FoundJournal> journals = find_journals();
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
      const std::string name = entry.path().filename().string();
      const bool own = name.starts_with("test-") && name.ends_with(".stl");
      if (own && !is_needed(journals, entry.path().string())) {
        std::filesystem::remove(entry.path(), error);
      }
    }
  }

  int descriptor_ = -1;
  std::string kept_;
  std::string journal_;
};

std::string own_key(std::string key) {
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

// What the user typed must not be changed silently.
Status check_assignments(const Options& options, const Calibration& calibration) {
  for (const auto& [typed, value] : options.settings.assignments) {
    const std::string key = own_key(typed);
    const auto fixed = std::find_if(calibration.settings.begin(), calibration.settings.end(),
                                    [&](const auto& own) { return own.first == key; });
    if (fixed == calibration.settings.end() || fixed->second == value) continue;
    return core::Error{
        core::ErrorCode::kBadSetting,
        fmt::format("{} = {}: rind test {} needs {} = {}; leave it out", key, value,
                    options.test.name, key, fixed->second.empty() ? "nothing" : fixed->second)};
  }
  return {};
}

void add_settings_of(const Calibration& calibration, Options& options) {
  auto& assignments = options.settings.assignments;
  for (const auto& own : calibration.settings) assignments.push_back(own);
  if (!calibration.at_height.empty()) {
    assignments.emplace_back("at_height", write_lines(calibration.at_height));
  }
}

void tell(const Calibration& calibration, const Options& options, Reporter& reporter) {
  if (!options.json) {
    reporter.note("test", "\n" + calibration_text(calibration, options.test.name));
    return;
  }
  std::string advice;
  for (const std::string& line : calibration.advice) advice += (advice.empty() ? "" : " ") + line;
  reporter.note("test", advice, {{"test", options.test.name}, {"setting", calibration.key}});
  for (const CalibrationBlock& block : calibration.blocks) {
    reporter.event("test_block", {{"from_mm", block.bottom.mm()},
                                  {"to_mm", block.top.mm()},
                                  {"setting", calibration.key},
                                  {"value", block.value}});
  }
}

bool may_be_resumed(const Options& options) {
  if (!options.output.path.empty() || options.print.no_journal) return false;
  if (!options.print.journal.empty()) return true;
  return options.link.port != "virtual" && !journal_directory().empty();
}

int write_body(const std::string& stl, const Calibration& calibration, const Options& options,
               Reporter& reporter) {
  if (Status written = write_output(options.output.path, stl); !written.ok()) {
    return fail(written.error(), reporter);
  }
  reporter.note("done", fmt::format("{}: {} facets; its settings and actions are not in it",
                                    options.output.path, calibration.solid.facets().size()));
  tell(calibration, options, reporter);
  return kExitDone;
}

}  // namespace

int test_command(const Options& told, Reporter& reporter) {
  Options options = told;
  const Result<WholeSettings> whole = whole_settings(options.settings);
  if (!whole.ok()) return fail(whole.error(), reporter);
  const TestOptions& test = options.test;
  const Result<Calibration> planned =
      plan_calibration({test.name, test.from, test.to, test.step}, whole.value().settings);
  if (!planned.ok()) return fail(planned.error(), reporter);
  const Calibration& calibration = planned.value();
  if (Status fine = check_assignments(options, calibration); !fine.ok())
    return fail(fine.error(), reporter);
  add_settings_of(calibration, options);
  const std::string stl = calibration.solid.stl();
  if (options.output.path.ends_with(".stl")) return write_body(stl, calibration, options, reporter);
  BodyFile body;
  const Status there = may_be_resumed(options) ? body.keep(stl, test.name, options.print.journal)
                                               : body.hold(stl, test.name);
  if (!there.ok()) return fail(there.error(), reporter);
  options.part.path = body.path();
  options.part.title = "test " + test.name;
  const bool prints = options.output.path.empty();
  options.subcommand = prints ? Subcommand::kPrint : Subcommand::kSlice;
  if (prints) tell(calibration, options, reporter);
  const int exit_code =
      prints ? print_command(options, reporter) : slice_command(options, reporter);
  // Behind a print's messages it is found again when the part is taken off the bed.
  if (exit_code == kExitDone && !(prints && options.json)) tell(calibration, options, reporter);
  return exit_code;
}

}  // namespace host
