// Reads the command line and runs a command (commands/).
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <new>
#include <utility>
#include <variant>

#include "host/commands/commands.h"
#include "host/commands/output_names.h"
#include "host/files/log_file.h"
#include "host/files/output_file.h"
#include "host/settings/options.h"
#include "host/system/exit_codes.h"
#include "host/system/memory_budget.h"
#include "host/system/stop_signals.h"

namespace {

int run(const host::Options& options, host::Reporter& reporter) {
  switch (options.subcommand) {
    case host::Subcommand::kPrint:
      return host::print_command(options, reporter);
    case host::Subcommand::kResume:
      return host::resume_command(options, reporter);
    case host::Subcommand::kSlice:
      return host::slice_command(options, reporter);
    case host::Subcommand::kPlan:
      return host::plan_command(options, reporter);
    case host::Subcommand::kShow:
      return host::show_command(options, reporter);
    case host::Subcommand::kPorts:
      return host::ports_command(options, reporter);
    case host::Subcommand::kSettings:
      return host::settings_command(options, reporter);
    case host::Subcommand::kFormats:
      return host::formats_command(options, reporter);
    case host::Subcommand::kPresets:
      return host::presets_command(options, reporter);
    case host::Subcommand::kSetup:
      return host::setup_command(options, reporter);
    case host::Subcommand::kTest:
      return host::test_command(options, reporter);
    case host::Subcommand::kTell:
      return host::tell_command(options, reporter);
  }
  return host::kExitUsage;
}

// Opens standard input, output and error if they are closed: the first files opened would get their
// numbers otherwise and be written to. The substitutes can't be written to.
void take_standard_descriptors() {
  int descriptor = -1;
  do {
    descriptor = ::open("/dev/null", O_RDONLY);
  } while (descriptor >= 0 && descriptor <= STDERR_FILENO);
  if (descriptor >= 0) ::close(descriptor);
}

int tell_instead(const host::OptionsExit& exit) {
  if (exit.exit_code != host::kExitDone) {
    host::Reporter({.quiet = false, .json = exit.json, .stdout_taken = false})
        .error(exit.text, exit.exit_code);
    return exit.exit_code;
  }
  const core::Status told = host::write_standard_output(exit.text);
  if (told.ok()) return exit.exit_code;
  std::fprintf(stderr, "rind: %s\n", told.error().message.c_str());
  return host::kExitBadInput;
}

}  // namespace

int main(int argc, char** argv) {
  take_standard_descriptors();
  const auto parsed = host::parse_options(argc, argv);
  if (const auto* exit = std::get_if<host::OptionsExit>(&parsed)) return tell_instead(*exit);
  const auto& options = std::get<host::Options>(parsed);
  host::set_heaps(host::threads_at_work(options.threads));
  host::watch_stop_signals();
  host::Reporter reporter({options.quiet, options.json,
                           host::result_on_standard_output(options) ||
                               options.subcommand == host::Subcommand::kPlan ||
                               options.subcommand == host::Subcommand::kSettings});
  host::set_last_words(reporter.words_of_error(host::stopped_message(options), host::kExitStopped));
  try {
    if (core::Status fine = host::check_output_names(options); !fine.ok()) {
      return host::fail(fine.error(), reporter);
    }
    if (!options.log.empty()) {
      auto log = host::LogFile::open(options.log);
      if (!log.ok()) return host::fail(log.error(), reporter);
      reporter.log_to(std::move(log).value());
    }
    host::set_memory_limit(static_cast<std::int64_t>(options.memory_limit_bytes));
    return run(options, reporter);
  } catch (const std::bad_alloc&) {
    reporter.error(host::memory_refusal() + "; allow more, or simplify the mesh",
                   host::kExitBadInput);
    return host::kExitBadInput;
  } catch (const std::exception& error) {
    // An unexpected exception of a library.
    reporter.error(std::string("gave up: ") + error.what(), host::kExitBadInput);
    return host::kExitBadInput;
  }
}
