// Random bytes as a controller's answers: they are cut into lines and read without a crash, and a
// line is the same however its bytes came.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "firmware_link/dialects/dialects.h"
#include "firmware_link/wire/capabilities.h"
#include "firmware_link/wire/reply.h"

namespace {

std::vector<std::string> lines_of(std::span<const std::byte> bytes, std::size_t piece) {
  std::vector<std::string> lines;
  firmware_link::LineSplitter splitter;
  while (!bytes.empty()) {
    std::span<const std::byte> part = bytes.first(std::min(piece, bytes.size()));
    bytes = bytes.subspan(part.size());
    while (!part.empty()) {
      part = part.subspan(splitter.take(part));
      if (const auto line = splitter.line()) lines.emplace_back(*line);
    }
  }
  return lines;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  const std::vector<std::string> lines = lines_of(bytes, size + 1);
  if (lines != lines_of(bytes, 1)) std::abort();
  firmware_link::Capabilities capabilities;
  for (const std::string& line : lines) {
    const firmware_link::Reply reply = firmware_link::read_reply(line);
    firmware_link::note_capability(reply.text, capabilities);
    const std::string name = firmware_link::firmware_name_in(reply.text);
    for (const char* speaker : {"Marlin", "Klipper", "RepRapFirmware", "Prusa-Firmware"}) {
      (void)firmware_link::dialect_for(speaker)->meaning_of(reply);
    }
    (void)firmware_link::dialect_for(name);
  }
  return 0;
}
