// A zip archive, read entry by entry, each as a stream.
//
// The list of entries is at a zip's end, so what comes through a pipe is copied to a temporary file
// first. Bombs are refused by what the list says: an entry larger than kZipBombBytes that unpacks
// to more than kZipBombRatio times its size.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"               // Result
#include "host/files/input_file.h"     // InputFile
#include "host/formats/xml_scanner.h"  // XmlScanner::ByteSource

namespace host {

// Meshes written as XML pack to a fifth or a tenth.
inline constexpr std::uint64_t kZipBombRatio = 100;
inline constexpr std::uint64_t kZipBombBytes = std::uint64_t{32} << 20;
inline constexpr std::int64_t kZipEntriesMax = std::int64_t{1} << 16;

// What is alike in all spellings of an entry's name.
[[nodiscard]] std::string entry_key(std::string_view name);

class ZipArchive {
 public:
  static core::Result<ZipArchive> open(InputFile file);
  ~ZipArchive();
  ZipArchive(ZipArchive&&) noexcept;

  // Names of entries mean the same in any case, with backslashes for slashes, and with what they
  // have of "%20" and the like written out.
  [[nodiscard]] bool contains(const std::string& entry) const;
  // The first entry whose name ends so, in any case; empty for none.
  [[nodiscard]] std::string find_ending(const std::string& ending) const;
  // All that are no folders, in the archive's order.
  [[nodiscard]] std::vector<std::string> entries() const;
  // Entries whose content is asked for again begin anew. Valid as long as this.
  [[nodiscard]] core::Result<XmlScanner::ByteSource> bytes_of(const std::string& entry) const;
  // The entry as a file of its own: unpacked into a temporary file without a name.
  [[nodiscard]] core::Result<InputFile> unpacked(const std::string& entry) const;

  // The file's, for messages.
  [[nodiscard]] const std::string& name() const;

 private:
  struct State;
  explicit ZipArchive(std::shared_ptr<State> state);
  std::shared_ptr<State> state_;
};

}  // namespace host
