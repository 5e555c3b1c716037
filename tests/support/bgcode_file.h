// Writes binary G-code files (.bgcode), by other means than the reader's: from the description
// alone (github.com/prusa3d/libbgcode, doc/specifications.md). Packs badly, but rightly.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace test {

inline std::string low_first(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text.push_back(static_cast<char>(value >> (8 * i) & 0xff));
  return text;
}

// Bit by bit, as the polynomial has it.
inline std::uint32_t crc32_of(std::string_view bytes) {
  std::uint32_t sum = 0xffffffff;
  for (const char byte : bytes) {
    sum ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ ((sum & 1) != 0 ? 0xedb88320 : 0);
  }
  return ~sum;
}

// zlib's format with stored blocks alone.
inline std::string stored_zlib(std::string_view bytes) {
  std::string packed = "\x78\x01";
  std::uint32_t a = 1, b = 0;
  for (const char byte : bytes) {
    a = (a + static_cast<unsigned char>(byte)) % 65'521;
    b = (b + a) % 65'521;
  }
  do {
    const std::size_t size = std::min<std::size_t>(bytes.size(), 65'535);
    packed += size == bytes.size() ? '\1' : '\0';
    packed += low_first(size, 2) + low_first(~size, 2);
    packed += bytes.substr(0, size);
    bytes.remove_prefix(size);
  } while (!bytes.empty());
  for (const std::uint32_t half : {b, a}) {
    packed.push_back(static_cast<char>(half >> 8));
    packed.push_back(static_cast<char>(half & 0xff));
  }
  return packed;
}

// The longest match in the window at each place, found by trying all.
inline std::string heatshrunk(std::string_view bytes, int window, int lookahead) {
  std::string packed;
  unsigned held = 0;
  int count = 0;
  const auto put = [&](std::size_t value, int bits) {
    for (int bit = bits - 1; bit >= 0; --bit) {
      held = held << 1 | (value >> bit & 1);
      if (++count % 8 == 0) packed.push_back(static_cast<char>(held & 0xff));
    }
  };
  for (std::size_t at = 0; at < bytes.size();) {
    std::size_t best = 0, back = 0;
    const std::size_t farthest = std::min<std::size_t>(at, std::size_t{1} << window);
    for (std::size_t distance = 1; distance <= farthest && distance <= 300; ++distance) {
      std::size_t length = 0;
      while (at + length < bytes.size() && length < std::size_t{1} << lookahead &&
             bytes[at + length] == bytes[at + length - distance]) {
        ++length;
      }
      if (length > best) best = length, back = distance;
    }
    if (best < 3) {
      put(1, 1);
      put(static_cast<unsigned char>(bytes[at++]), 8);
    } else {
      put(0, 1);
      put(back - 1, window);
      put(best - 1, lookahead);
      at += best;
    }
  }
  while (count % 8 != 0) put(0, 1);
  return packed;
}

// Lines that start with G packed, without blanks; all others as they are.
inline std::string meat_packed_text(std::string_view text) {
  constexpr std::string_view kPacked = "0123456789.E\nGX";
  std::string packed = "\xff\xff\xfb\xff\xff\xf7";  // on, no blanks
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    std::string line(text.substr(0, end));
    text.remove_prefix(end);
    if (line[0] != 'G') {
      packed += "\xff\xff\xfa" + line + "\xff\xff\xfb";
      continue;
    }
    std::erase(line, ' ');
    // Every line starts on a byte; behind its end comes whatever.
    for (std::size_t i = 0; i < line.size(); i += 2) {
      const std::size_t first = kPacked.find(line[i]);
      const char next = i + 1 < line.size() ? line[i + 1] : '0';
      const std::size_t second = kPacked.find(next);
      const auto half = [](std::size_t found) {
        return found == std::string_view::npos ? std::size_t{15} : found;
      };
      packed.push_back(static_cast<char>(half(first) | half(second) << 4));
      if (first == std::string_view::npos) packed.push_back(line[i]);
      if (second == std::string_view::npos) packed.push_back(next);
    }
  }
  return packed;
}

struct BgcodeForm {
  int compression = 3;  // 0 none, 1 deflate, 2 heatshrink 11,4, 3 heatshrink 12,4
  int encoding = 2;     // 0 none, 1 MeatPack, 2 MeatPack with comments
  bool sums = true;
  std::size_t block_bytes = 2'000;
  bool cuts_lines = false;  // blocks end anywhere, not at ends of lines
};

inline std::string bgcode_block(int kind, const BgcodeForm& form, const std::string& parameters,
                                const std::string& data) {
  std::string packed = data;
  if (form.compression == 1) packed = stored_zlib(data);
  if (form.compression >= 2) packed = heatshrunk(data, form.compression + 9, 4);
  std::string block = low_first(static_cast<std::uint64_t>(kind), 2) +
                      low_first(static_cast<std::uint64_t>(form.compression), 2) +
                      low_first(data.size(), 4);
  if (form.compression != 0) block += low_first(packed.size(), 4);
  block += parameters + packed;
  return form.sums ? block + low_first(crc32_of(block), 4) : block;
}

// REQUIRES: no carriage returns in the text; a line that starts with G has no comment.
inline std::string bgcode_of(std::string_view text, const BgcodeForm& form) {
  std::string file = "GCDE" + low_first(1, 4) + low_first(form.sums ? 1 : 0, 2);
  const BgcodeForm stored{1, 0, form.sums};
  const BgcodeForm plain{0, 0, form.sums};
  file += bgcode_block(0, stored, low_first(0, 2), "Producer=a test\n");
  file += bgcode_block(3, plain, low_first(0, 2), "printer_model=none\n");
  file += bgcode_block(5, plain, low_first(0, 2) + low_first(16, 2) + low_first(16, 2),
                       std::string(100'000, 'p'));
  file += bgcode_block(4, stored, low_first(0, 2),
                       "filament used [mm]=1\nestimated printing time (normal mode)=1h 2m 3s\n");
  file += bgcode_block(2, stored, low_first(0, 2), std::string(90'000, 's'));
  while (!text.empty()) {
    std::size_t size = std::min(text.size(), form.block_bytes);
    if (!form.cuts_lines && size < text.size()) size = text.rfind('\n', size - 1) + 1;
    const std::string part(text.substr(0, size));
    text.remove_prefix(size);
    file += bgcode_block(1, form, low_first(static_cast<std::uint64_t>(form.encoding), 2),
                         form.encoding == 0 ? part : meat_packed_text(part));
  }
  return file;
}

}  // namespace test
