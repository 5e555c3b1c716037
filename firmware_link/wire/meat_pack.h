// MeatPack, as Marlin has it (Cap:MEATPACK:1): two frequent characters in a byte, the first in its
// low half.
//
//     0 … 9  ten digits      10  .     11  blank     12  end of line     13  G     14  X
//     15     none of these: the character itself comes as a byte of its own behind this one
//
//     "G1X10.5\n"   ->   1D 1E 00  A? …      every line starts on a byte: what is left of the last
//                                           one behind an end of line is filled with zeros
//
// Two bytes FF and a third command the unpacker itself; it answers each with a line of its own,
// "[MP] PV01 ON ESP". (Marlin 2.1, its class MeatPack; measured.)
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "firmware_link/wire/limits.h"  // kLineBytesMax

namespace firmware_link {

inline constexpr std::string_view kMeatPackOn = "\xff\xff\xfb";
inline constexpr std::string_view kMeatPackReset = "\xff\xff\xf9";  // off, and nothing half read
inline constexpr std::string_view kMeatPackAnswer = "[MP]";

// A line with its end: three halves a character at most.
using PackedBuffer = std::array<char, (kLineBytesMax + 1) * 3 / 2 + 2>;

// A line without its end, packed with it. REQUIRES: at most kLineBytesMax printable characters.
[[nodiscard]] std::string_view meat_packed(std::string_view line, PackedBuffer& into);

// What a controller does with bytes as they arrive.
class MeatUnpacker {
 public:
  struct Result {
    std::array<char, 4> characters{};  // four only of damaged bytes
    std::size_t count = 0;
    bool commanded = false;  // it has a line to say: state()
    bool refused = false;    // over 127, while nothing is packed
  };

  [[nodiscard]] Result take(std::uint8_t byte);

  // "ON ESP", "OFF ESP": whether it unpacks, and has blanks.
  [[nodiscard]] std::string_view state() const;

 private:
  void command(std::uint8_t byte);
  void unpack(std::uint8_t byte, Result& result);

  bool on_ = false;
  bool no_blanks_ = false;
  bool command_next_ = false;
  int marks_ = 0;             // FF in a row
  int whole_characters_ = 0;  // to come as they are
  char behind_whole_ = 0;     // follows the first of these
};

}  // namespace firmware_link
