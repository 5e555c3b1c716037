#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "host/commands/commands.h"
#include "host/printing/journal_directory.h"  // find_journals
#include "host/printing/request_pipe.h"       // tell_print
#include "host/system/exit_codes.h"
#include "host/system/stage_clock.h"  // steady_seconds

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

// How long a print may take to note in its journal that an object is cancelled.
constexpr double kConfirm_s = 3;

bool is_named(const FoundJournal& journal, const std::string& name) {
  return name.empty() || journal.path == name ||
         (journal.content &&
          (is_of_part(journal, name) || journal.content->head.part_title == name));
}

std::string part_of(const FoundJournal& journal) {
  return journal.content ? journal.content->head.part_title : journal.path;
}

// The one running print that is meant.
Result<FoundJournal> running_print(const std::string& name) {
  std::vector<FoundJournal> running = find_journals();
  std::erase_if(running, [&](const FoundJournal& journal) {
    return journal.standing != JournalStanding::kHeld || !is_named(journal, name);
  });
  if (running.empty() && !name.empty()) {
    // A journal elsewhere.
    std::optional<FoundJournal> one = find_journal(name);
    if (one && one->standing == JournalStanding::kHeld) running.push_back(*std::move(one));
  }
  if (running.size() == 1) return running.front();
  const std::string of = name.empty() ? "" : " of " + name;
  if (running.empty()) {
    return Error{ErrorCode::kUnreadable, "no print" + of + " is running that keeps a journal"};
  }
  std::string text = "several prints" + of + " are running; name one with --print:";
  for (const FoundJournal& journal : running) {
    text += fmt::format("\n  {}  {}", part_of(journal), journal.path);
  }
  return Error{ErrorCode::kUnreadable, text};
}

bool confirms(const std::string& journal, int object) {
  const double until_s = steady_seconds() + kConfirm_s;
  while (steady_seconds() < until_s) {
    const Result<JournalContent> read = read_journal(journal);
    if (read.ok()) {
      const std::vector<CancelledObject>& cancelled = read.value().record.cancelled;
      if (std::any_of(cancelled.begin(), cancelled.end(),
                      [object](const CancelledObject& one) { return one.object == object - 1; }))
        return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

}  // namespace

int tell_command(const Options& options, Reporter& reporter) {
  const std::optional<TypedRequest> request = request_of_line(options.request);
  if (!request) {
    reporter.error(fmt::format("'{}' is no request; there are: pause, resume, stop, cancel N",
                               options.request),
                   kExitUsage);
    return kExitUsage;
  }
  const Result<FoundJournal> print = running_print(options.print.journal);
  if (!print.ok()) return fail(print.error(), reporter);
  const std::string& journal = print.value().path;
  if (const core::Status told = tell_print(journal, options.request); !told.ok()) {
    return fail(told.error(), reporter);
  }
  if (request->request) {
    reporter.note("told", fmt::format("{}: {}", part_of(print.value()), options.request));
    return kExitDone;
  }
  if (confirms(journal, request->object)) {
    reporter.note(
        "told", fmt::format("{}: object {} is cancelled", part_of(print.value()), request->object));
    return kExitDone;
  }
  return fail(Error{ErrorCode::kUnreadable,
                    fmt::format("{}: the print was told to cancel object {}, but its journal does "
                                "not say that it is; its own messages tell why",
                                part_of(print.value()), request->object)},
              reporter);
}

}  // namespace host
