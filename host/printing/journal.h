// What a print keeps on the disk so that it can be resumed (`rind resume`) after a crash, a lost
// cable or a power cut. A file of fixed size (journal_file.h tells who may write it):
//
//     │ head: part, settings, port │ record A │ record B │ record C │ record D │
//       written once, a text         synced in turn,       between these, in turn,
//                                    every kSyncPeriod_s   on each change, not synced
//
// Each record has a sequence number and a checksum; the whole record with the highest number
// counts. A program that is killed loses nothing, because the system keeps what was written. A
// power cut loses what was not synced: at most kSyncPeriod_s of printing, and never the record
// before.
//
// A sync writes one block, and no other part of the file. The system writes the other records by
// itself, every half minute (SyncPace, kJournalDayBytesMax).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"                   // Result, Status
#include "core/settings.h"                 // Settings
#include "host/printing/journal_file.h"    // HeldFile
#include "host/printing/journal_record.h"  // JournalRecord

namespace host {

// Head and records start at multiples of this, so that a disk that dies while it writes one of them
// damages no other.
inline constexpr std::size_t kJournalBlockBytes = 4'096;
inline constexpr std::size_t kJournalRecords = 4;
static_assert(kRecordBytesMax <= kJournalBlockBytes);

// How much printing a power cut may cost.
inline constexpr double kSyncPeriod_s = 5;
// How often a system writes what was not synced (Linux: dirty_expire_centisecs; a busy system
// writes sooner), and how many bytes a print that never pauses writes to the disk in a day.
inline constexpr double kWriteBackPeriod_s = 30;
inline constexpr double kJournalDayBytesMax = 150e6;
static_assert(86'400 * kJournalBlockBytes * (1 / kSyncPeriod_s + 2 / kWriteBackPeriod_s) <=
              kJournalDayBytesMax);
// A head with a thousand lines of start and end G-code, and long names.
inline constexpr std::size_t kJournalHeadBytesMax = std::size_t{1} << 19;

struct JournalHead {
  std::string version;                  // of rind: another one may lay other roads
  std::string part;                     // absolute path
  std::vector<std::string> more_parts;  // likewise, of what is printed beside it
  std::string part_title;               // for people
  std::uint64_t part_hash = 0;          // of all parts (contents_of)
  std::int64_t part_bytes = 0;
  std::vector<std::pair<std::string, std::string>> settings;  // all, as describe_settings() tells
  std::string on_bad_layer;                                   // the option's word
  std::string on_floating;                                    // likewise
  std::string port;
  std::string usb;  // what `rind ports` tells of it
  int baud = 0;
  std::string boot;  // the system's boot: another one means a power cut or a restart
};

[[nodiscard]] std::string head_bytes(const JournalHead& head);

// When a record is synced: the print has advanced since the last sync, and that was long ago.
class SyncPace {
 public:
  // Whether to sync now; if so, it counts as done.
  [[nodiscard]] bool due(double now_s, std::int64_t sure) {
    if (sure == sure_ || (sure_ >= 0 && now_s - at_s_ < kSyncPeriod_s)) return false;
    at_s_ = now_s;
    sure_ = sure;
    return true;
  }

 private:
  double at_s_ = 0;
  std::int64_t sure_ = -1;
};

class Journal {
 public:
  // Makes the file and its folder, or replaces a journal that is of no use. `sets_aside`: that of
  // an interrupted print is set aside for it (journal_file.h). Errors: another file, an interrupted
  // print, a running one.
  [[nodiscard]] static core::Result<Journal> create(const std::string& path,
                                                    const JournalHead& head,
                                                    bool sets_aside = false);
  // Opens one that exists: what is noted from now on follows its last record.
  [[nodiscard]] static core::Result<Journal> reopen(const std::string& path);

  Journal(Journal&& other) noexcept;
  Journal& operator=(Journal&&) = delete;
  ~Journal();

  // Before the first record: what was not known when the file was made. False: it does not fit.
  [[nodiscard]] bool set_head(const JournalHead& head);

  // Writes the record. `sync`: it shall outlive a power cut; another thread waits for the disk.
  // COSTS: a write of kRecordBytesMax at most. failed() tells of a full disk.
  void note(const JournalRecord& record, bool sync);

  // The same, and waits until it is on the disk.
  void note_last(const JournalRecord& record);

  // Replaces all records, because line numbers mean something else from now on.
  void renumber(const JournalRecord& record);

  // The print is done, or never started: there is nothing to resume.
  void remove();

  [[nodiscard]] const std::string& path() const { return path_; }
  // Why the last write failed; empty when it did not.
  [[nodiscard]] const std::string& failed() const { return failed_; }
  // Whether a record was ever written, by this program or one before.
  [[nodiscard]] bool has_record() const { return sequence_ > 0; }

 private:
  class Syncer;

  Journal(std::string path, HeldFile file, std::int64_t records_at, std::int64_t sequence);
  // Returns what it wrote.
  std::string write(const JournalRecord& record, std::size_t slot);
  [[nodiscard]] std::int64_t offset_of(std::size_t slot) const;

  std::string path_;
  HeldFile file_;
  std::int64_t records_at_;
  std::int64_t sequence_;
  std::size_t synced_turn_ = 0;    // which of the two synced slots is next
  std::size_t unsynced_turn_ = 0;  // likewise
  std::string failed_;
  std::unique_ptr<Syncer> syncer_;
};

struct JournalContent {
  JournalHead head;
  JournalRecord record;
};

// From a file's bytes. Errors: no journal, a journal of another form, a damaged head, no whole
// record (the print was interrupted before its first road).
[[nodiscard]] core::Result<JournalContent> read_journal_bytes(const std::string& bytes,
                                                              const std::string& name);
[[nodiscard]] core::Result<JournalContent> read_journal(const std::string& path);
// Whether the journal is whole and has no record: the print was interrupted before its first road.
[[nodiscard]] bool is_empty_journal(const std::string& path);

// The system's boot; empty where it does not tell.
[[nodiscard]] std::string boot_name();

}  // namespace host
