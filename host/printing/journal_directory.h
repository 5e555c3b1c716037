// The directory of journals that the user has not named, and which journals are there.
//
//     $XDG_STATE_HOME/rind, or ~/.local/state/rind
//         NAME-HASH.journal         the part's file name, and a hash of its whole path
//         NAME-HASH-2.journal …     when a running print holds the one before: one part on several
//                                   printers
//         NAME-HASH.journal.old     set aside by --anew (journal_file.h)
#pragma once

#include <cstdint>
#include <ctime>
#include <optional>
#include <string>
#include <vector>

#include "host/printing/journal.h"       // JournalContent
#include "host/printing/journal_file.h"  // JournalStanding

namespace host {

// Prints of one part that run at the same time, each with its own journal.
inline constexpr int kPrintsOfOnePartMax = 16;
// Journals that are listed; the newest ones.
inline constexpr std::size_t kJournalsListedMax = 1'000;

// Empty: there is no such directory ($HOME is not set).
[[nodiscard]] std::string journal_directory();

// `number`: 1 … kPrintsOfOnePartMax. Empty: there is no such directory.
[[nodiscard]] std::string default_journal_path(const std::string& part, int number = 1);

struct FoundJournal {
  std::string path;
  JournalStanding standing = JournalStanding::kResumable;  // or kHeld
  std::optional<JournalContent> content;                   // nothing: `why` it can't be read
  std::string why;
  std::time_t written = 0;
};

// The journal with that name, if one is held or worth keeping.
[[nodiscard]] std::optional<FoundJournal> find_journal(const std::string& path);

// All in the directory, newest first.
[[nodiscard]] std::vector<FoundJournal> find_journals();

// Whether a journal is of the part with that path.
[[nodiscard]] bool is_of_part(const FoundJournal& journal, const std::string& part);

// Which journal a print of the part gets, and which prints of it were interrupted. Empty path: all
// names are taken, or there is no directory.
struct JournalChoice {
  std::string path;
  std::vector<FoundJournal> interrupted;
};
[[nodiscard]] JournalChoice choose_journal(const std::string& part);

// "layer 12 of 40": the layer that the print would resume with.
[[nodiscard]] std::string layer_text(const JournalRecord& record);
// Why it was interrupted.
[[nodiscard]] std::string state_text(PrintState state);
// Local time, "2026-11-27 20:41".
[[nodiscard]] std::string time_text(std::time_t time);

}  // namespace host
