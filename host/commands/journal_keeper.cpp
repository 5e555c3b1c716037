#include "host/commands/journal_keeper.h"

#include <utility>

#include "host/printing/journal_file.h"  // set_aside

namespace host {

void JournalKeeper::take_up(Journal journal) {
  journal_.emplace(std::move(journal));
  started_ = true;
}

core::Status JournalKeeper::reserve(Reporter& reporter) {
  if (!plan_ || journal_) return {};
  core::Result<Journal> made = Journal::create(plan_->path, plan_->head, plan_->sets_aside);
  if (!made.ok()) {
    if (plan_->named) return made.error();
    reporter.note("warning", made.error().message + "; this print can't be resumed");
    return {};
  }
  journal_.emplace(std::move(made).value());
  for (const std::string& other : plan_->set_aside) {
    if (core::Status aside = set_aside(other); !aside.ok()) {
      reporter.note("warning", aside.error().message);
    }
  }
  return {};
}

void JournalKeeper::part_known(const FileContent& content) {
  const std::lock_guard lock(mutex_);
  content_ = content;
}

Journal* JournalKeeper::journal() {
  if (!journal_) return nullptr;
  if (started_) return &*journal_;
  {
    const std::lock_guard lock(mutex_);
    if (!content_) return nullptr;
    plan_->head.part_hash = content_->hash;
    plan_->head.part_bytes = content_->bytes;
  }
  if (!journal_->set_head(plan_->head)) {
    drop_if_empty();
    return nullptr;
  }
  started_ = true;
  return &*journal_;
}

void JournalKeeper::drop_if_empty() {
  if (!journal_ || journal_->has_record()) return;
  journal_->remove();
  journal_.reset();
}

std::string JournalKeeper::resumable_path() const {
  return journal_ && read_journal(journal_->path()).ok() ? journal_->path() : std::string();
}

}  // namespace host
