#include "host/output/png_writer.h"

#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/check.h"

namespace host {
namespace {

void append_number(std::uint32_t number, std::string& bytes) {
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(number >> shift & 0xFFU);
}

const Bytef* bytes_of(std::string_view text) { return reinterpret_cast<const Bytef*>(text.data()); }

void append_chunk(std::string_view type, std::string_view content, std::string& file) {
  append_number(static_cast<std::uint32_t>(content.size()), file);
  const std::size_t start = file.size();
  file += type;
  file += content;
  const std::string_view checked = std::string_view(file).substr(start);
  const uLong crc = crc32(0, bytes_of(checked), static_cast<uInt>(checked.size()));
  append_number(static_cast<std::uint32_t>(crc), file);
}

// Each row has the number of its filter before it: 0, none.
std::string rows_of(const RgbaPicture& picture) {
  const std::size_t row_bytes = std::size_t{4} * static_cast<std::size_t>(picture.width);
  const std::string_view pixels(reinterpret_cast<const char*>(picture.bytes.data()),
                                picture.bytes.size());
  std::string rows;
  rows.reserve(pixels.size() + static_cast<std::size_t>(picture.height));
  for (std::size_t at = 0; at < pixels.size(); at += row_bytes) {
    rows += '\0';
    rows += pixels.substr(at, row_bytes);
  }
  return rows;
}

std::string compressed(std::string_view bytes) {
  std::string packed(compressBound(static_cast<uLong>(bytes.size())), '\0');
  uLongf size = static_cast<uLongf>(packed.size());
  const int done = compress2(reinterpret_cast<Bytef*>(packed.data()), &size, bytes_of(bytes),
                             static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION);
  RIND_CHECK(done == Z_OK);
  packed.resize(size);
  return packed;
}

}  // namespace

std::string png_of(const RgbaPicture& picture, std::string_view software) {
  RIND_CHECK(picture.width >= 1 && picture.height >= 1);
  std::string head;
  append_number(static_cast<std::uint32_t>(picture.width), head);
  append_number(static_cast<std::uint32_t>(picture.height), head);
  // 8 bits a channel; colour with opacity; deflate; filters by row; not interlaced.
  head += std::string_view("\x08\x06\0\0\0", 5);
  std::string file = "\x89PNG\r\n\x1A\n";
  append_chunk("IHDR", head, file);
  if (!software.empty()) {
    append_chunk("tEXt", std::string("Software") + '\0' + std::string(software), file);
  }
  append_chunk("IDAT", compressed(rows_of(picture)), file);
  append_chunk("IEND", {}, file);
  return file;
}

}  // namespace host
