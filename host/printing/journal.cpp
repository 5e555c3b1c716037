#include "host/printing/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <thread>

#include "host/part/content_hash.h"  // hash_of

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

Error failure(const std::string& path, const std::string& what) {
  return {ErrorCode::kUnreadable, path + ": " + what + ": " + std::strerror(errno)};
}

bool write_at(int descriptor, std::string_view bytes, std::int64_t at) {
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(descriptor, bytes.data(), bytes.size(), at);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
    at += count;
  }
  return true;
}

// So that a new name outlives a power cut.
void sync_folder(const std::string& path) {
  const std::string folder = std::filesystem::absolute(path).parent_path().string();
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  (void)::fsync(descriptor);
  ::close(descriptor);
}

// Open, and held by nobody else.
Result<int> hold(const std::string& path, int flags) {
  const int descriptor = ::open(path.c_str(), flags | O_RDWR | O_CLOEXEC, 0600);
  if (descriptor < 0) return failure(path, "the journal can't be opened");
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  ::close(descriptor);
  return Error{
      ErrorCode::kUnreadable,
      path + ": another rind is printing with this journal; name another one by --journal"};
}

}  // namespace

// Waits for the disk, so that the link does not have to.
class Journal::Syncer {
 public:
  explicit Syncer(int descriptor) : descriptor_(descriptor), thread_([this] { run(); }) {}
  ~Syncer() {
    {
      const std::lock_guard lock(mutex_);
      ends_ = true;
    }
    changed_.notify_one();
    thread_.join();
  }
  Syncer(const Syncer&) = delete;
  Syncer& operator=(const Syncer&) = delete;

  [[nodiscard]] bool busy() const { return busy_.load(); }

  void begin() {
    {
      const std::lock_guard lock(mutex_);
      busy_.store(true);
    }
    changed_.notify_one();
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return busy_.load() || ends_; });
      if (ends_) return;
      lock.unlock();
      (void)::fdatasync(descriptor_);
      lock.lock();
      busy_.store(false);
    }
  }

  int descriptor_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<bool> busy_ = false;
  bool ends_ = false;  // by mutex_
  std::thread thread_;
};

Result<Journal> Journal::create(const std::string& path, const JournalHead& head) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::absolute(path, error).parent_path();
  std::filesystem::create_directories(folder, error);
  if (std::filesystem::exists(path, error)) {
    const Result<int> old = hold(path, 0);
    if (!old.ok()) return old.error();
    ::close(old.value());
  }
  const std::string partial = path + ".partial";
  const Result<int> opened = hold(partial, O_CREAT | O_TRUNC);
  if (!opened.ok()) return opened.error();
  const int descriptor = opened.value();
  const std::string bytes = head_bytes(head);
  const auto records_at = static_cast<std::int64_t>(bytes.size());
  const bool written =
      write_at(descriptor, bytes, 0) &&
      ::ftruncate(descriptor, records_at + static_cast<std::int64_t>(kJournalRecords *
                                                                     kJournalBlockBytes)) == 0 &&
      ::fsync(descriptor) == 0 && ::rename(partial.c_str(), path.c_str()) == 0;
  if (!written) {
    Error why = failure(path, "the journal can't be written");
    ::close(descriptor);
    ::unlink(partial.c_str());
    return why;
  }
  sync_folder(path);
  return Journal(path, descriptor, records_at, 0);
}

Result<Journal> Journal::go_on(const std::string& path) {
  const Result<int> held = hold(path, 0);
  if (!held.ok()) return held.error();
  struct stat status {};
  (void)::fstat(held.value(), &status);
  const auto records = static_cast<std::int64_t>(kJournalRecords * kJournalBlockBytes);
  std::string bytes(static_cast<std::size_t>(records), '\0');
  const std::int64_t at = status.st_size - records;
  if (at < 0 || ::pread(held.value(), bytes.data(), bytes.size(), at) != records) {
    ::close(held.value());
    return Error{ErrorCode::kUnreadable, path + ": the journal is too short"};
  }
  Journal journal(path, held.value(), at, 0);
  // Behind the newest, and not over it.
  for (std::size_t slot = 0; slot < kJournalRecords; ++slot) {
    const auto read = read_record(std::string_view(bytes).substr(slot * kJournalBlockBytes));
    if (!read || read->sequence < journal.sequence_) continue;
    journal.sequence_ = read->sequence + 1;
    journal.synced_turn_ = slot == 0 ? 1 : 0;
    journal.loose_turn_ = slot == 2 ? 1 : 0;
  }
  return journal;
}

Journal::Journal(std::string path, int descriptor, std::int64_t records_at, std::int64_t sequence)
    : path_(std::move(path)),
      descriptor_(descriptor),
      records_at_(records_at),
      sequence_(sequence),
      syncer_(std::make_unique<Syncer>(descriptor)) {}

Journal::Journal(Journal&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      records_at_(other.records_at_),
      sequence_(other.sequence_),
      synced_turn_(other.synced_turn_),
      loose_turn_(other.loose_turn_),
      failed_(std::move(other.failed_)),
      syncer_(std::move(other.syncer_)) {}

Journal::~Journal() {
  syncer_.reset();
  if (descriptor_ >= 0) ::close(descriptor_);
}

void Journal::write(const JournalRecord& record, std::size_t slot) {
  const std::int64_t at = records_at_ + static_cast<std::int64_t>(slot * kJournalBlockBytes);
  if (write_at(descriptor_, record_bytes(record, sequence_), at)) {
    ++sequence_;
    failed_.clear();
  } else {
    failed_ = std::strerror(errno);
  }
}

void Journal::note(const JournalRecord& record, bool sync) {
  if (sync && !syncer_->busy()) {
    write(record, synced_turn_);
    synced_turn_ = 1 - synced_turn_;
    syncer_->begin();
    return;
  }
  write(record, 2 + loose_turn_);
  loose_turn_ = 1 - loose_turn_;
}

void Journal::note_last(const JournalRecord& record) {
  syncer_ = nullptr;  // waits for what it is at
  write(record, synced_turn_);
  synced_turn_ = 1 - synced_turn_;
  (void)::fdatasync(descriptor_);
  syncer_ = std::make_unique<Syncer>(descriptor_);
}

void Journal::remove() {
  ::unlink(path_.c_str());
  sync_folder(path_);
}

std::string default_journal_path(const std::string& part) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::weakly_canonical(part, error);
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  std::string folder;
  if (state != nullptr && *state == '/') {
    folder = state;
  } else if (home != nullptr && *home == '/') {
    folder = std::string(home) + "/.local/state";
  } else {
    return {};
  }
  return fmt::format("{}/rind/{}-{:08x}.journal", folder, whole.filename().string(),
                     static_cast<std::uint32_t>(hash_of(whole.string())));
}

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
