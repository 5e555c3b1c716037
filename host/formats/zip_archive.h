// Reads the entries of a zip archive as streams.
//
// The list of entries is at the archive's end, so an archive from a pipe is first copied to a
// temporary file. Zip bombs are refused: an entry that unpacks to more than kZipBombBytes and to
// more than kZipBombRatio times its packed size, according to the list.
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

// Meshes written as XML shrink to a fifth or a tenth.
inline constexpr std::uint64_t kZipBombRatio = 100;
inline constexpr std::uint64_t kZipBombBytes = std::uint64_t{32} << 20;
inline constexpr std::int64_t kZipEntriesMax = std::int64_t{1} << 16;

// The key under which all spellings of an entry's name are equal.
[[nodiscard]] std::string entry_key(std::string_view name);

class ZipArchive {
 public:
  static core::Result<ZipArchive> open(InputFile file);
  ~ZipArchive();
  ZipArchive(ZipArchive&&) noexcept;

  // Names of entries are equal in upper and lower case, with slashes or backslashes, and with or
  // without escapes such as "%20".
  [[nodiscard]] bool contains(const std::string& entry) const;
  // The first entry whose name has that ending, in any case; empty if there is none.
  [[nodiscard]] std::string find_ending(const std::string& ending) const;
  // All entries that are not folders, in the archive's order.
  [[nodiscard]] std::vector<std::string> entries() const;
  // The entry's content, from its start at each call. Valid as long as this.
  [[nodiscard]] core::Result<XmlScanner::ByteSource> bytes_of(const std::string& entry) const;
  // The entry as a file of its own: unpacked into a temporary file without a name.
  [[nodiscard]] core::Result<InputFile> unpacked(const std::string& entry) const;

  // The file's name, for messages.
  [[nodiscard]] const std::string& name() const;

 private:
  struct State;
  explicit ZipArchive(std::shared_ptr<State> state);
  std::shared_ptr<State> state_;
};

}  // namespace host
