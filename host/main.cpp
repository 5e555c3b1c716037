// Arguments in, exit code out; the rest is in commands/.
#include <cstdio>
#include <exception>
#include <new>
#include <utility>
#include <variant>

#include "host/commands/commands.h"
#include "host/exit_codes.h"
#include "host/log_file.h"
#include "host/memory_budget.h"
#include "host/printing/stop_signals.h"
#include "host/settings/options.h"

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
  }
  return host::kExitUsage;
}

}  // namespace

int main(int argc, char** argv) {
  const auto parsed = host::parse_options(argc, argv);
  if (const auto* refused = std::get_if<host::OptionsExit>(&parsed)) {
    std::fputs(refused->text.c_str(), refused->exit_code == host::kExitDone ? stdout : stderr);
    return refused->exit_code;
  }
  const auto& options = std::get<host::Options>(parsed);
  host::share_heaps(options.jobs);
  host::watch_stop_signals();
  host::Reporter reporter({options.quiet, options.json,
                           options.output == "-" || options.subcommand == host::Subcommand::kPlan});
  try {
    if (!options.log.empty()) {
      auto log = host::LogFile::open(options.log);
      if (!log.ok()) {
        reporter.error(log.error().message, host::kExitBadInput);
        return host::kExitBadInput;
      }
      reporter.log_to(std::move(log).value());
    }
    host::set_memory_limit(static_cast<std::int64_t>(options.memory_limit_bytes));
    return run(options, reporter);
  } catch (const std::bad_alloc&) {
    reporter.error(host::memory_refusal() + "; allow more, or simplify the mesh",
                   host::kExitBadInput);
    return host::kExitBadInput;
  } catch (const std::exception& error) {
    // A library's surprise.
    reporter.error(std::string("gave up: ") + error.what(), host::kExitBadInput);
    return host::kExitBadInput;
  }
}
