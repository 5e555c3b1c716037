// The blocks of a binary G-code file (Prusa's .bgcode, version 1): one after the other, each
// checked by its checksum.
//
//     "GCDE" version checksum-kind │ block │ block │ …
//     block: kind, compression, sizes │ parameters │ data │ CRC-32 of all of these
//
// (github.com/prusa3d/libbgcode, doc/specifications.md; all numbers lowest byte first.)
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/result.h"              // Result
#include "host/files/content_hash.h"  // kHashStart
#include "host/gcode/file_bytes.h"    // FileBytes

namespace host {

// The longest block of G-code that is read, packed or not: PrusaSlicer writes 64 KiB.
inline constexpr std::size_t kBlockBytesMax = std::size_t{1} << 20;
// Of metadata no more is kept.
inline constexpr std::size_t kMetadataBytesMax = std::size_t{64} * 1'024;

enum class BlockKind : std::uint16_t {
  kFileMetadata,
  kGcode,
  kSlicerMetadata,
  kPrinterMetadata,
  kPrintMetadata,
  kThumbnail,
};

struct BgcodeBlock {
  BlockKind kind = BlockKind::kGcode;
  std::int64_t at = 0;         // where its header starts in the file
  std::uint16_t encoding = 0;  // its first parameter
  std::string data;            // unpacked; empty where a block is only checked
};

class BgcodeBlocks {
 public:
  // The bytes outlive this.
  explicit BgcodeBlocks(const FileBytes& bytes) : bytes_(bytes) {}

  // The next block. G-code and metadata of the print are unpacked, all others checked alone.
  // nullopt at the end. Errors name block and byte: a damaged one, one that is too long, a form
  // that is not known.
  [[nodiscard]] core::Result<std::optional<BgcodeBlock>> next();

  // Goes on with the block whose header starts there.
  void go_to(std::int64_t at);

  [[nodiscard]] std::int64_t position() const { return at_; }
  // Of all bytes so far, if they were read from the start.
  [[nodiscard]] std::uint64_t hash() const { return hash_; }

 private:
  struct Header;

  [[nodiscard]] core::Status read(std::size_t size, std::string& into);
  [[nodiscard]] core::Status pass_over(std::int64_t size);
  [[nodiscard]] core::Status open();
  [[nodiscard]] core::Result<Header> header();
  [[nodiscard]] core::Status check_sum();
  [[nodiscard]] core::Status unpack(const Header& header, std::string packed, BgcodeBlock& block);
  [[nodiscard]] core::Error bad(const std::string& why) const;

  const FileBytes& bytes_;
  std::int64_t at_ = 0;
  std::uint64_t hash_ = kHashStart;
  bool opened_ = false;
  bool sums_ = true;       // blocks have checksums
  std::uint32_t sum_ = 0;  // of the block so far
  std::int64_t block_at_ = 0;
  std::int64_t number_ = 0;  // of the block; 0: not counted from the start
};

}  // namespace host
