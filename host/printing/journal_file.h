// A journal's file: how it gets its name, who holds it, what it may replace, how it is removed.
//
// A journal is a regular file whose first bytes are "rind journal ". The program that writes it
// holds an exclusive flock() on it, from before the file has its name until the program ends. So a
// file is
//
//     locked                 a print is running with it: refused, whatever the options
//     ours, with a record    an interrupted print: replaced only when that was asked for, and then
//                            set aside as NAME.old
//     ours, without one      nothing could be resumed from it: replaced
//     anything else          refused: other files, links, folders, devices, pipes
//
// A new one is made under a random name (NAME.partial-XXXXXX, O_EXCL), locked and synced, and then
// gets its name only where there is none (RENAME_NOREPLACE): of two prints that start at the same
// moment with one name, one is refused. The name is deleted only while it is that of the held file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/result.h"  // Result, Status

namespace host {

inline constexpr std::string_view kJournalWord = "rind journal ";

// Where an old journal is kept when its name is taken by a new one.
[[nodiscard]] std::string set_aside_name(const std::string& path);
// Gives it that name, and replaces an older journal there. Errors: it is no journal, or is held.
[[nodiscard]] core::Status set_aside(const std::string& path);

enum class JournalStanding {
  kAbsent,
  kHeld,       // by a running program
  kResumable,  // has a record, or is a journal that this program can't read: worth keeping
  kEmpty,      // ours, without any record
  kForeign,    // no journal
};

// Looks, and changes nothing. `why`: of kForeign.
struct JournalLook {
  JournalStanding standing = JournalStanding::kAbsent;
  std::string why;
};
[[nodiscard]] JournalLook look_at_journal(const std::string& path);

// An open journal's descriptor, locked; closing it sets it free.
class HeldFile {
 public:
  // One that exists; its name may not be a link.
  [[nodiscard]] static core::Result<HeldFile> take(const std::string& path);
  // A new one with that content, synced. `sets_aside`: the journal of an
  // interrupted print is set aside for it.
  [[nodiscard]] static core::Result<HeldFile> make(const std::string& path,
                                                   std::string_view content, bool sets_aside);

  HeldFile(HeldFile&& other) noexcept;
  HeldFile& operator=(HeldFile&&) = delete;
  ~HeldFile();

  [[nodiscard]] int descriptor() const { return descriptor_; }
  // Whether the name still is this file.
  [[nodiscard]] bool is_named(const std::string& path) const;
  // Writes all; false: errno says why.
  [[nodiscard]] bool write(std::string_view bytes, std::int64_t at) const;
  // Another descriptor of it whose writes are on the disk when they end; -1: there is none.
  [[nodiscard]] int opened_for_sync() const;
  // Deletes the name, if that still is this file.
  void remove(const std::string& path) const;

 private:
  explicit HeldFile(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace host
