// The journal of one print, from the plan to the end.
//
//     planned    its name is chosen, and no journal worth keeping has that name (journal_file.h)
//     reserved   the controller has answered: the file exists, and is locked
//     started    the part has been read, and its hash is in the head: records can be written
//     dropped    the print ended before its first road: the file is deleted
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
  bool named = false;                  // by --journal: without it there is no print
  bool sets_aside = false;             // the journal of an interrupted print that has its name
  std::vector<std::string> set_aside;  // journals of other names that are set aside, too
};

class JournalKeeper {
 public:
  // Keeps no journal.
  JournalKeeper() = default;

  void plan(JournalPlan plan) { plan_ = std::move(plan); }
  // Keeps one that was opened again.
  void take_up(Journal journal);

  // When the controller has answered. An error: the print may not start.
  [[nodiscard]] core::Status reserve(Reporter& reporter);
  // For any thread: the part has been read, and this is its content.
  void part_known(const FileContent& content);

  // Null until it has started.
  [[nodiscard]] Journal* journal();

  // Of the journal that is held for the print; empty: none is.
  [[nodiscard]] std::string held_path() const { return journal_ ? journal_->path() : ""; }

  // The print has ended.
  void drop_if_empty();

  // Its path, if the print can be resumed from it; empty otherwise.
  [[nodiscard]] std::string resumable_path() const;

 private:
  std::optional<JournalPlan> plan_;
  std::mutex mutex_;
  std::optional<FileContent> content_;  // by mutex_
  std::optional<Journal> journal_;
  bool started_ = false;
};

}  // namespace host
