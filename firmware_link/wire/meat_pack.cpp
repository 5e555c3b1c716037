#include "firmware_link/wire/meat_pack.h"

#include "firmware_link/wire/check.h"

namespace firmware_link {
namespace {

constexpr std::string_view kHalves = "0123456789. \nGX";
constexpr std::uint8_t kWhole = 15;
constexpr std::uint8_t kMark = 0xff;

std::uint8_t half_of(char c) {
  const std::size_t at = kHalves.find(c);
  return at == std::string_view::npos ? kWhole : static_cast<std::uint8_t>(at);
}

}  // namespace

std::string_view meat_packed(std::string_view line, PackedBuffer& into) {
  LINK_CHECK(line.size() <= kLineBytesMax);
  std::size_t size = 0;
  for (std::size_t i = 0; i <= line.size(); i += 2) {
    const auto at = [&](std::size_t k) { return k < line.size() ? line[k] : '\n'; };
    const bool last = i == line.size();
    const std::uint8_t low = half_of(at(i));
    const std::uint8_t high = last ? 0 : half_of(at(i + 1));
    into[size++] = static_cast<char>(low | high << 4);
    if (low == kWhole) into[size++] = at(i);
    if (high == kWhole) into[size++] = at(i + 1);
  }
  return {into.data(), size};
}

MeatUnpacker::Result MeatUnpacker::take(std::uint8_t byte) {
  Result result;
  if (byte == kMark) {
    if (marks_ > 0) {
      command_next_ = true;
      marks_ = 0;
    } else {
      marks_ = 1;
    }
    return result;
  }
  if (command_next_) {
    command_next_ = false;
    command(byte);
    result.commanded = true;
    return result;
  }
  if (marks_ > 0) {
    marks_ = 0;
    unpack(kMark, result);
  }
  unpack(byte, result);
  return result;
}

void MeatUnpacker::command(std::uint8_t byte) {
  switch (byte) {
    case 0xfb:
      on_ = true;
      break;
    case 0xfa:
      on_ = false;
      break;
    case 0xf9:
      *this = MeatUnpacker();
      break;
    case 0xf7:
      no_blanks_ = true;
      break;
    case 0xf6:
      no_blanks_ = false;
      break;
    default:
      break;
  }
}

void MeatUnpacker::unpack(std::uint8_t byte, Result& result) {
  const auto put = [&result](char c) { result.characters[result.count++] = c; };
  if (!on_) {
    if (byte > 127) {
      result.refused = true;
    } else {
      put(static_cast<char>(byte));
    }
    return;
  }
  if (whole_characters_ > 0) {
    put(static_cast<char>(byte));
    if (behind_whole_ != 0) put(behind_whole_);
    behind_whole_ = 0;
    --whole_characters_;
    return;
  }
  const auto character = [this](unsigned half) {
    return half == 11 && no_blanks_ ? 'E' : kHalves[half];
  };
  const unsigned low = byte & 15U, high = byte >> 4U;
  if (low == kWhole) {
    ++whole_characters_;
    if (high == kWhole) {
      ++whole_characters_;
    } else {
      behind_whole_ = character(high);
    }
    return;
  }
  put(character(low));
  if (result.characters[result.count - 1] == '\n') return;
  if (high == kWhole) {
    ++whole_characters_;
  } else {
    put(character(high));
  }
}

std::string_view MeatUnpacker::state() const {
  if (on_) return no_blanks_ ? "ON NSP" : "ON ESP";
  return no_blanks_ ? "OFF NSP" : "OFF ESP";
}

}  // namespace firmware_link
