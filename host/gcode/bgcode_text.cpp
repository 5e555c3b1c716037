#include "host/gcode/bgcode_text.h"

#include <algorithm>
#include <string>
#include <utility>

#include "firmware_link/wire/meat_pack.h"  // MeatUnpacker
#include "host/gcode/bgcode_blocks.h"

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

// How the text of a block is written. Whether comments are kept makes no difference to a reader.
enum Encoding : std::uint16_t { kPlain, kMeatPack, kMeatPackWithComments };

// Each block is packed by itself. Without blanks, "G1X5Y6" comes as "G1 X5 Y6" again, because a
// controller may take the E behind a number for an exponent.
std::string meat_unpacked(const std::string& packed) {
  firmware_link::MeatUnpacker unpacker;
  std::string text;
  text.reserve(packed.size() * 2);
  bool in_command = false;  // of a line that starts with G
  const auto put = [&](char c) {
    const bool starts = text.empty() || text.back() == '\n';
    if (starts) in_command = c == 'G';
    if (c == ';') in_command = false;
    const bool letter = c >= 'A' && c <= 'Z';
    if (in_command && letter && !starts && text.back() != ' ') text.push_back(' ');
    text.push_back(c);
  };
  for (const char byte : packed) {
    const auto result = unpacker.take(static_cast<std::uint8_t>(byte));
    const bool has_blanks = unpacker.state().ends_with("ESP");
    for (std::size_t i = 0; i < result.count; ++i) {
      if (has_blanks) {
        text.push_back(result.characters[i]);
      } else {
        put(result.characters[i]);
      }
    }
    // In comments, where nothing is packed.
    if (result.refused) text.push_back(byte);
  }
  return text;
}

class BgcodeText final : public GcodeText {
 public:
  explicit BgcodeText(const FileBytes& bytes) : blocks_(bytes) {}

  Result<std::string_view> next() override {
    while (true) {
      Result<std::optional<BgcodeBlock>> read = blocks_.next();
      if (!read.ok()) return read.error();
      if (!read.value()) return std::string_view();
      BgcodeBlock& block = *read.value();
      if (block.kind == BlockKind::kPrintMetadata) {
        if (metadata_.empty()) metadata_ = std::move(block.data);
        continue;
      }
      if (block.kind != BlockKind::kGcode) continue;
      if (block.encoding > kMeatPackWithComments) {
        return Error{ErrorCode::kBadPart, "byte " + std::to_string(block.at) +
                                              ": G-code in an encoding that is not known"};
      }
      block_at_ = block.at;
      if (block.encoding == kPlain) {
        text_ = std::move(block.data);
      } else {
        text_ = meat_unpacked(block.data);
      }
      within_ = std::exchange(skip_, 0);
      if (within_ >= text_.size()) continue;
      return std::string_view(text_).substr(within_);
    }
  }
  core::Status go_to(const TextPlace& place) override {
    blocks_.go_to(place.block);
    skip_ = static_cast<std::size_t>(std::max<std::int64_t>(0, place.within));
    return {};
  }
  [[nodiscard]] TextPlace place_in(std::size_t byte) const override {
    return {block_at_, static_cast<std::int64_t>(within_ + byte)};
  }
  [[nodiscard]] const std::string& metadata() const override { return metadata_; }
  [[nodiscard]] std::int64_t bytes_read() const override { return blocks_.position(); }
  [[nodiscard]] std::uint64_t hash() const override { return blocks_.hash(); }

 private:
  BgcodeBlocks blocks_;
  std::int64_t block_at_ = 0;
  std::string text_;
  std::size_t within_ = 0;  // text_ starts in the block's text
  std::size_t skip_ = 0;
  std::string metadata_;
};

}  // namespace

std::unique_ptr<GcodeText> bgcode_text(const FileBytes& bytes) {
  return std::make_unique<BgcodeText>(bytes);
}

}  // namespace host
