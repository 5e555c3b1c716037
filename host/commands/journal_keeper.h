// The journal of one print, from the plan to the end.
//
//     planned    its name is chosen, and that nothing worth keeping has it (journal_file.h)
//     reserved   the controller has answered: the file is there, and locked
//     begun      the part has been read through, and what tells it is in the head
//     dropped    the print ended before its first road: nothing is left behind
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"              // Status
#include "host/files/content_hash.h"  // FileContent
#include "host/printing/journal.h"    // Journal, JournalHead
#include "host/printing/progress.h"   // Reporter

namespace host {

struct JournalPlan {
  std::string path;
  JournalHead head;
  bool told = false;                   // by --journal: without it there is no print
  bool anew = false;                   // a print that was cut may be set aside
  std::vector<std::string> set_aside;  // journals of other names that are set aside with it
};

class JournalKeeper {
 public:
  // None is kept.
  JournalKeeper() = default;

  void plan(JournalPlan plan) { plan_ = std::move(plan); }
  // Takes up one that was read.
  void take_up(Journal journal);

  // When the controller has answered. An error: the print may not begin.
  [[nodiscard]] core::Status reserve(Reporter& reporter);
  // From any thread: the part has been read, this is its content.
  void part_known(const FileContent& content);

  // Null as long as nothing can be noted.
  [[nodiscard]] Journal* journal();

  // The print has ended.
  void drop_if_empty();

  // Where it is, when there is something to resume; empty: nowhere.
  [[nodiscard]] std::string resumable_path() const;

 private:
  std::optional<JournalPlan> plan_;
  std::mutex mutex_;
  std::optional<FileContent> content_;  // by mutex_
  std::optional<Journal> journal_;
  bool begun_ = false;
};

}  // namespace host
