// Where journals are kept when nobody says, and which are there.
//
//     $XDG_STATE_HOME/rind, or ~/.local/state/rind
//         NAME-HASH.journal         the part's file name, and a sum of its whole path
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

// Prints of one part at the same time that have a journal each.
inline constexpr int kPrintsOfOnePartMax = 16;
// Journals that are listed; the newest ones.
inline constexpr std::size_t kJournalsListedMax = 1'000;

// Empty: there is no such place.
[[nodiscard]] std::string journal_folder();

// `turn`: 1 … kPrintsOfOnePartMax. Empty: there is no place.
[[nodiscard]] std::string default_journal_path(const std::string& part, int turn = 1);

struct FoundJournal {
  std::string path;
  JournalStanding standing = JournalStanding::kResumable;  // or kHeld
  std::optional<JournalContent> content;                   // nothing: `why` it can't be read
  std::string why;
  std::time_t written = 0;
};

// A journal of ours with that name, held or worth keeping; nothing: there is none.
[[nodiscard]] std::optional<FoundJournal> find_journal(const std::string& path);

// All in the folder, newest first.
[[nodiscard]] std::vector<FoundJournal> find_journals();

// Whether a journal is of the part with that path.
[[nodiscard]] bool is_of_part(const FoundJournal& journal, const std::string& part);

// Which journal a print of the part is to have, and which prints of it were cut. Empty path: all
// names are taken, or there is no place.
struct JournalChoice {
  std::string path;
  std::vector<FoundJournal> cut;
};
[[nodiscard]] JournalChoice choose_journal(const std::string& part);

// "layer 12 of 40": the layer that the print would go on with.
[[nodiscard]] std::string layer_text(const JournalRecord& record);
// Why it was cut.
[[nodiscard]] std::string state_text(PrintState state);
// Local time, "2026-11-27 20:41".
[[nodiscard]] std::string time_text(std::time_t time);

}  // namespace host
