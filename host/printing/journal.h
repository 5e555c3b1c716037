// What a print leaves on the disk so that it can be gone on with after a crash, a lost cable or a
// power cut (`rind resume`). A file of fixed size:
//
//     │ head: part, settings, port │ record A │ record B │ record C │ record D │
//       written once, a text         synced in turn,       between these, in turn,
//                                    every kSyncPeriod_s   on each change, not synced
//                                    and at layers' ends
//
// Each record has a sequence number and a checksum; the highest whole one counts. A program that is
// killed loses nothing, since the system keeps what was written; a power cut loses what was not
// synced: at most kSyncPeriod_s of printing, or a layer, and never the record before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"                   // Result, Status
#include "core/settings.h"                 // Settings
#include "host/printing/journal_record.h"  // JournalRecord

namespace host {

inline constexpr double kSyncPeriod_s = 2;
// Parts of the file begin at multiples of this, so that a disk that dies in the middle of writing
// one damages no other.
inline constexpr std::size_t kJournalBlockBytes = 4'096;
inline constexpr std::size_t kJournalRecords = 4;
// A head with a thousand lines of G-code at begin and end, and long names.
inline constexpr std::size_t kJournalHeadBytesMax = std::size_t{1} << 19;

struct JournalHead {
  std::string version;     // of rind: another one may lay other roads
  std::string part;        // absolute path
  std::string part_title;  // for people
  std::uint64_t part_hash = 0;
  std::int64_t part_bytes = 0;
  std::vector<std::pair<std::string, std::string>> settings;  // all, as describe_settings() tells
  std::string on_bad_layer;                                   // the option's word
  std::string port;
  std::string usb;  // what `rind ports` tells of it
  int baud = 0;
  std::string boot;  // the system's boot: another one means a power cut or a restart
};

[[nodiscard]] std::string head_bytes(const JournalHead& head);

class Journal {
 public:
  // Makes the file, or replaces one that no running program holds; its folder too.
  [[nodiscard]] static core::Result<Journal> create(const std::string& path,
                                                    const JournalHead& head);
  // Takes up one that was read: what is noted from now on comes behind its last record.
  [[nodiscard]] static core::Result<Journal> go_on(const std::string& path);

  Journal(Journal&& other) noexcept;
  Journal& operator=(Journal&&) = delete;
  ~Journal();

  // Writes the record; `sync`: so that it outlives a power cut, which another thread waits for.
  // COSTS: a write of kRecordBytes. A full disk is told once, by failed().
  void note(const JournalRecord& record, bool sync);

  // The same, and waits until it is on the disk.
  void note_last(const JournalRecord& record);

  // The print is done: nothing is left to resume.
  void remove();

  [[nodiscard]] const std::string& path() const { return path_; }
  // Why the last write failed; empty when it did not.
  [[nodiscard]] const std::string& failed() const { return failed_; }

 private:
  class Syncer;

  Journal(std::string path, int descriptor, std::int64_t records_at, std::int64_t sequence);
  void write(const JournalRecord& record, std::size_t slot);

  std::string path_;
  int descriptor_;
  std::int64_t records_at_;
  std::int64_t sequence_;
  std::size_t synced_turn_ = 0;
  std::size_t loose_turn_ = 0;
  std::string failed_;
  std::unique_ptr<Syncer> syncer_;
};

struct JournalContent {
  JournalHead head;
  JournalRecord record;
};

// Of the file's bytes. Errors: no journal, one of another version of the file's form, a damaged
// head, no whole record (the print was cut before its first road).
[[nodiscard]] core::Result<JournalContent> read_journal_bytes(const std::string& bytes,
                                                              const std::string& name);
[[nodiscard]] core::Result<JournalContent> read_journal(const std::string& path);

// Where a print's journal is kept when nobody says: $XDG_STATE_HOME/rind, or
// ~/.local/state/rind; by the part's name and path. Empty: there is no such place.
[[nodiscard]] std::string default_journal_path(const std::string& part);

// The system's boot; empty where it does not tell.
[[nodiscard]] std::string boot_name();

}  // namespace host
