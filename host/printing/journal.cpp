#include "host/printing/journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <thread>
#include <utility>

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

constexpr std::size_t kUnsyncedSlot = 2;  // the first one that is not synced

}  // namespace

// Waits for the disk in place of the link.
class Journal::Syncer {
 public:
  explicit Syncer(const HeldFile& file)
      : file_descriptor_(file.descriptor()),
        descriptor_(file.opened_for_sync()),
        thread_([this] { run(); }) {}
  ~Syncer() {
    {
      const std::lock_guard lock(mutex_);
      ends_ = true;
    }
    changed_.notify_one();
    thread_.join();
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Syncer(const Syncer&) = delete;
  Syncer& operator=(const Syncer&) = delete;

  [[nodiscard]] bool busy() const { return busy_.load(); }

  // Syncs the bytes that were written at that offset.
  void start(std::string bytes, std::int64_t at) {
    {
      const std::lock_guard lock(mutex_);
      bytes_ = std::move(bytes);
      at_ = at;
      busy_.store(true);
    }
    changed_.notify_one();
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return busy_.load() || ends_; });
      if (ends_ && !busy_.load()) return;
      lock.unlock();
      // Writes the same bytes again, by a descriptor that syncs: their block alone is waited for.
      if (::pwrite(descriptor_, bytes_.data(), bytes_.size(), at_) !=
          static_cast<ssize_t>(bytes_.size())) {
        (void)::fdatasync(file_descriptor_);
      }
      lock.lock();
      busy_.store(false);
    }
  }

  int file_descriptor_;
  int descriptor_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string bytes_;  // by mutex_, and while busy_ the thread's
  std::int64_t at_ = 0;
  std::atomic<bool> busy_ = false;
  bool ends_ = false;  // by mutex_
  std::thread thread_;
};

Result<Journal> Journal::create(const std::string& path, const JournalHead& head, bool sets_aside) {
  std::string bytes = head_bytes(head);
  const auto records_at = static_cast<std::int64_t>(bytes.size());
  // No hole in the file, so that a record needs no new block of the disk.
  bytes.resize(bytes.size() + kJournalRecords * kJournalBlockBytes, '\0');
  Result<HeldFile> file = HeldFile::make(path, bytes, sets_aside);
  if (!file.ok()) return file.error();
  return Journal(path, std::move(file).value(), records_at, 0);
}

Result<Journal> Journal::reopen(const std::string& path) {
  Result<HeldFile> held = HeldFile::take(path);
  if (!held.ok()) return held.error();
  const Result<JournalContent> read = read_journal(path);
  if (!read.ok()) return read.error();
  const auto records_at = static_cast<std::int64_t>(head_bytes(read.value().head).size());
  std::string bytes(kJournalRecords * kJournalBlockBytes, '\0');
  const ssize_t count = ::pread(held.value().descriptor(), bytes.data(), bytes.size(), records_at);
  if (count < 0) return Error{ErrorCode::kUnreadable, path + ": " + std::strerror(errno)};
  Journal journal(path, std::move(held).value(), records_at, 0);
  // A file that was cut short gets its length back.
  const auto whole = static_cast<std::size_t>(count);
  if (!journal.file_.write(std::string_view(bytes).substr(whole),
                           records_at + static_cast<std::int64_t>(whole))) {
    return Error{ErrorCode::kUnreadable, path + ": " + std::strerror(errno)};
  }
  // The next record must not overwrite the newest one.
  for (std::size_t slot = 0; slot < kJournalRecords; ++slot) {
    const auto old = read_record(std::string_view(bytes).substr(slot * kJournalBlockBytes));
    if (!old || old->sequence < journal.sequence_) continue;
    journal.sequence_ = old->sequence + 1;
    journal.synced_turn_ = slot == 0 ? 1 : 0;
    journal.unsynced_turn_ = slot == kUnsyncedSlot ? 1 : 0;
  }
  return journal;
}

Journal::Journal(std::string path, HeldFile file, std::int64_t records_at, std::int64_t sequence)
    : path_(std::move(path)),
      file_(std::move(file)),
      records_at_(records_at),
      sequence_(sequence),
      syncer_(std::make_unique<Syncer>(file_)) {}

Journal::Journal(Journal&& other) noexcept = default;

Journal::~Journal() = default;

bool Journal::set_head(const JournalHead& head) {
  const std::string bytes = head_bytes(head);
  if (static_cast<std::int64_t>(bytes.size()) != records_at_ || !file_.write(bytes, 0)) {
    return false;
  }
  (void)::fdatasync(file_.descriptor());
  return true;
}

std::int64_t Journal::offset_of(std::size_t slot) const {
  return records_at_ + static_cast<std::int64_t>(slot * kJournalBlockBytes);
}

std::string Journal::write(const JournalRecord& record, std::size_t slot) {
  std::string bytes = record_bytes(record, sequence_);
  if (file_.write(bytes, offset_of(slot))) {
    ++sequence_;
    failed_.clear();
  } else {
    failed_ = std::strerror(errno);
  }
  return bytes;
}

void Journal::note(const JournalRecord& record, bool sync) {
  if (sync && !syncer_->busy()) {
    const std::size_t slot = synced_turn_;
    synced_turn_ = 1 - synced_turn_;
    std::string bytes = write(record, slot);
    syncer_->start(std::move(bytes), offset_of(slot));
    return;
  }
  (void)write(record, kUnsyncedSlot + unsynced_turn_);
  unsynced_turn_ = 1 - unsynced_turn_;
}

void Journal::note_last(const JournalRecord& record) {
  syncer_ = nullptr;  // waits for the sync under way
  (void)write(record, synced_turn_);
  synced_turn_ = 1 - synced_turn_;
  (void)::fdatasync(file_.descriptor());
  syncer_ = std::make_unique<Syncer>(file_);
}

void Journal::renumber(const JournalRecord& record) {
  // At each moment the newest record is whole.
  note_last(record);
  (void)write(record, kUnsyncedSlot + unsynced_turn_);
  (void)write(record, kUnsyncedSlot + 1 - unsynced_turn_);
  note_last(record);
}

void Journal::remove() { file_.remove(path_); }

std::string boot_name() {
  std::string name(64, '\0');
  const int descriptor = ::open("/proc/sys/kernel/random/boot_id", O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return {};
  const ssize_t count = ::read(descriptor, name.data(), name.size());
  ::close(descriptor);
  name.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  while (!name.empty() && name.back() == '\n') name.pop_back();
  return name;
}

}  // namespace host
