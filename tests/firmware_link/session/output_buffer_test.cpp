#include "firmware_link/session/output_buffer.h"

#include <doctest/doctest.h>

#include <string>

using namespace firmware_link;

namespace {

std::string text_of(const OutputBuffer& buffer) {
  const auto bytes = buffer.pending();
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

TEST_CASE("bytes leave in the order in which they were put, in parts as a port takes them") {
  OutputBuffer buffer;
  CHECK(buffer.empty());
  buffer.put("N1M115*7\n");
  buffer.put("\n");
  buffer.written(3);
  CHECK(text_of(buffer) == "115*7\n\n");
  buffer.put("M105\n");
  CHECK(text_of(buffer) == "115*7\n\nM105\n");
  buffer.written(12);
  CHECK(buffer.empty());
  buffer.put("x");
  buffer.clear();
  CHECK(buffer.empty());
}

TEST_CASE("all of the capacity is there, wherever the pending bytes start") {
  OutputBuffer buffer;
  std::string sent;
  std::string all;
  for (int i = 0; i < 1000; ++i) {
    const std::string piece(static_cast<std::size_t>(i * 37 % 200),
                            static_cast<char>('a' + i % 26));
    if (!buffer.has_room_for(piece.size())) {
      CHECK(text_of(buffer).size() + piece.size() > kOutputBytesMax);
      const std::size_t count = text_of(buffer).size() * 2 / 3;
      sent += text_of(buffer).substr(0, count);
      buffer.written(count);
    }
    if (!buffer.has_room_for(piece.size())) continue;
    buffer.put(piece);
    all += piece;
  }
  CHECK(sent + text_of(buffer) == all);
  buffer.clear();
  CHECK(buffer.has_room_for(kOutputBytesMax));
  CHECK_FALSE(buffer.has_room_for(kOutputBytesMax + 1));
}
