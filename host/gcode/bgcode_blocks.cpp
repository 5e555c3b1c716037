#include "host/gcode/bgcode_blocks.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "host/gcode/heatshrink.h"

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;

constexpr std::size_t kFileHeaderBytes = 10;
constexpr std::uint32_t kVersion1 = 1;
constexpr std::uint16_t kKindsKnown = 6;
constexpr std::size_t kPieceBytes = std::size_t{64} * 1'024;

enum Compression : std::uint16_t { kNone, kDeflate, kHeatshrink11, kHeatshrink12 };

std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = size; i > 0; --i) {
    value = value << 8 | static_cast<unsigned char>(bytes[at + i - 1]);
  }
  return value;
}

std::size_t parameter_bytes(BlockKind kind) { return kind == BlockKind::kThumbnail ? 6 : 2; }

bool inflated(std::string_view packed, std::size_t size, std::string& into) {
  into.resize(size);
  auto length = static_cast<uLongf>(size);
  const int result = ::uncompress(reinterpret_cast<Bytef*>(into.data()), &length,
                                  reinterpret_cast<const Bytef*>(packed.data()),
                                  static_cast<uLong>(packed.size()));
  return result == Z_OK && length == size;
}

}  // namespace

struct BgcodeBlocks::Header {
  BlockKind kind = BlockKind::kGcode;
  std::uint16_t compression = 0;
  std::uint32_t size = 0;    // unpacked
  std::uint32_t packed = 0;  // in the file
};

Error BgcodeBlocks::bad(const std::string& why) const {
  const std::string which = number_ > 0 ? fmt::format("block {}, ", number_) : "";
  return {ErrorCode::kBadPart,
          fmt::format("{}: {}byte {}: {}", bytes_.name(), which, block_at_, why)};
}

Status BgcodeBlocks::read(std::size_t size, std::string& into) {
  into.resize(size);
  const Result<std::size_t> count = bytes_.read(at_, into.data(), size);
  if (!count.ok()) return count.error();
  if (count.value() < size) return bad("the file ends within a block: it is not whole");
  at_ += static_cast<std::int64_t>(size);
  hash_ = hash_of(into, hash_);
  sum_ = static_cast<std::uint32_t>(
      ::crc32(sum_, reinterpret_cast<const Bytef*>(into.data()), static_cast<uInt>(size)));
  return {};
}

Status BgcodeBlocks::pass_over(std::int64_t size) {
  std::string piece;
  while (size > 0) {
    const auto part = std::min<std::int64_t>(size, kPieceBytes);
    if (Status passed = read(static_cast<std::size_t>(part), piece); !passed.ok()) return passed;
    size -= part;
  }
  return {};
}

Status BgcodeBlocks::open() {
  const std::int64_t from = std::exchange(at_, 0);
  std::string head;
  if (Status whole = read(kFileHeaderBytes, head); !whole.ok()) return whole;
  const std::uint32_t version = number_at(head, 4, 4);
  const std::uint32_t sums = number_at(head, 8, 2);
  if (!head.starts_with("GCDE")) return bad("this is no binary G-code");
  if (version != kVersion1) {
    return bad(
        fmt::format("binary G-code of version {}, of which nothing is known; export plain "
                    "G-code",
                    version));
  }
  if (sums > 1) return bad(fmt::format("checksums of kind {}, which is not known", sums));
  sums_ = sums == 1;
  opened_ = true;
  if (from > 0) at_ = from;
  return {};
}

void BgcodeBlocks::go_to(std::int64_t at) {
  at_ = at;
  number_ = 0;
}

Result<BgcodeBlocks::Header> BgcodeBlocks::header() {
  std::string bytes;
  if (Status whole = read(8, bytes); !whole.ok()) return whole.error();
  Header header;
  const std::uint32_t kind = number_at(bytes, 0, 2);
  header.compression = static_cast<std::uint16_t>(number_at(bytes, 2, 2));
  header.size = header.packed = number_at(bytes, 4, 4);
  if (kind >= kKindsKnown || header.compression > kHeatshrink12) {
    return bad(fmt::format("a block of kind {} and compression {}, which is not known", kind,
                           header.compression));
  }
  header.kind = static_cast<BlockKind>(kind);
  if (header.compression == kNone) return header;
  if (Status whole = read(4, bytes); !whole.ok()) return whole.error();
  header.packed = number_at(bytes, 0, 4);
  return header;
}

Status BgcodeBlocks::check_sum() {
  if (!sums_) return {};
  const std::uint32_t sum = sum_;
  std::string bytes;
  if (Status whole = read(4, bytes); !whole.ok()) return whole;
  if (number_at(bytes, 0, 4) != sum) return bad("its checksum does not fit: the file is damaged");
  return {};
}

Status BgcodeBlocks::unpack(const Header& header, std::string packed, BgcodeBlock& block) {
  bool whole = true;
  switch (header.compression) {
    case kNone:
      block.data = std::move(packed);
      break;
    case kDeflate:
      whole = inflated(packed, header.size, block.data);
      break;
    case kHeatshrink11:
      whole = unpack_heatshrink(packed, {11, 4}, header.size, block.data);
      break;
    default:
      whole = unpack_heatshrink(packed, {12, 4}, header.size, block.data);
      break;
  }
  if (!whole) return bad("it can't be unpacked: the file is damaged");
  return {};
}

Result<std::optional<BgcodeBlock>> BgcodeBlocks::next() {
  if (!opened_) {
    if (Status opened = open(); !opened.ok()) return opened.error();
  }
  if (at_ >= bytes_.size()) return std::optional<BgcodeBlock>();
  block_at_ = at_;
  if (number_ > 0 || at_ == kFileHeaderBytes) ++number_;
  sum_ = 0;
  const Result<Header> read_header = header();
  if (!read_header.ok()) return read_header.error();
  const Header& head = read_header.value();
  BgcodeBlock block;
  block.kind = head.kind;
  block.at = block_at_;
  std::string bytes;
  if (Status whole = read(parameter_bytes(head.kind), bytes); !whole.ok()) return whole.error();
  block.encoding = static_cast<std::uint16_t>(number_at(bytes, 0, 2));
  const bool gcode = head.kind == BlockKind::kGcode;
  const std::size_t longest = gcode ? kBlockBytesMax : kMetadataBytesMax;
  const bool fits = head.size <= longest && head.packed <= longest;
  if (gcode && !fits) {
    return bad(
        fmt::format("a block of {} bytes, {} packed; more than {} are not read: export plain "
                    "G-code",
                    head.size, head.packed, kBlockBytesMax));
  }
  const bool wanted = gcode || (head.kind == BlockKind::kPrintMetadata && fits);
  Status passed = wanted ? read(head.packed, bytes) : pass_over(head.packed);
  if (passed.ok()) passed = check_sum();
  if (passed.ok() && wanted) passed = unpack(head, std::move(bytes), block);
  if (!passed.ok()) return passed.error();
  return std::optional(std::move(block));
}

}  // namespace host
