#include "host/output/stroke_letters.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace host {
namespace {

// Each pair of figures is a point: x to the right in half units, y up in units from 2 below the
// base line. Capitals are 7 high, small letters 5. A blank begins another line.
struct Letter {
  char32_t code;
  int width;  // in half units
  std::string_view lines;
};

constexpr int kBase = 2;
constexpr double kCapital = 7;          // units
constexpr double kCapitalShare = 0.72;  // of the font's size
constexpr double kAcross = 0.56;        // a half unit across, in units
constexpr int kGap = 3;                 // between two letters, in half units
constexpr int kBlank = 3;

constexpr std::array kLetters = {
    Letter{U' ', kBlank, ""},
    Letter{U'!', 2, "1914 12"},
    Letter{U'"', 4, "1917 3937"},
    Letter{U'#', 8, "3912 7952 1787 0474"},
    Letter{U'$', 7, "785929080726557473522203 3931"},
    Letter{U'%', 8, "0289 0929270709 6484826264"},
    Letter{U'&', 7, "7217182949470403124275"},
    Letter{U'\'', 2, "1917"},
    Letter{U'(', 3, "39171331"},
    Letter{U')', 3, "09272301"},
    Letter{U'*', 6, "3935 1856 1658"},
    Letter{U'+', 6, "0565 3832"},
    Letter{U',', 2, "1200"},
    Letter{U'-', 4, "0545"},
    Letter{U'.', 2, "12"},
    Letter{U'/', 5, "0159"},
    Letter{U'0', 6, "294967644222040729"},
    Letter{U'1', 6, "183932 1252"},
    Letter{U'2', 6, "08294968660262"},
    Letter{U'3', 6, "0829496867466563422203 2646"},
    Letter{U'4', 6, "490464 4942"},
    Letter{U'5', 6, "690906466563422203"},
    Letter{U'6', 6, "5929070322426365462605"},
    Letter{U'7', 6, "096922"},
    Letter{U'8', 6, "294968674626070829 2605032242636546"},
    Letter{U'9', 6, "6645250608294968644212"},
    Letter{U':', 2, "12 16"},
    Letter{U';', 2, "1200 16"},
    Letter{U'<', 6, "670563"},
    Letter{U'=', 6, "0666 0464"},
    Letter{U'>', 6, "076503"},
    Letter{U'?', 6, "08294968673534 32"},
    Letter{U'@', 8, "64444666648487692907042262"},
    Letter{U'A', 8, "024982 2565"},
    Letter{U'B', 7, "0209 095978775606 5675735202"},
    Letter{U'C', 8, "8869390704326283"},
    Letter{U'D', 8, "0209 095987845202"},
    Letter{U'E', 7, "79090272 0656"},
    Letter{U'F', 7, "790902 0656"},
    Letter{U'G', 8, "88693907043262838555"},
    Letter{U'H', 8, "0902 8982 0686"},
    Letter{U'I', 2, "1912"},
    Letter{U'J', 6, "6964422204"},
    Letter{U'K', 8, "0902 8905 2682"},
    Letter{U'L', 7, "090272"},
    Letter{U'M', 8, "0209458982"},
    Letter{U'N', 8, "02098289"},
    Letter{U'O', 8, "395987845232040739"},
    Letter{U'P', 7, "0209 095978765505"},
    Letter{U'Q', 8, "395987845232040739 5481"},
    Letter{U'R', 7, "0209 095978765505 4572"},
    Letter{U'S', 7, "785929080726557473522203"},
    Letter{U'T', 8, "0989 4942"},
    Letter{U'U', 8, "090432528489"},
    Letter{U'V', 8, "094289"},
    Letter{U'W', 9, "0922587299"},
    Letter{U'X', 8, "0982 0289"},
    Letter{U'Y', 8, "094589 4542"},
    Letter{U'Z', 8, "09890282"},
    Letter{U'[', 3, "39191131"},
    Letter{U'\\', 5, "0951"},
    Letter{U']', 3, "09292101"},
    Letter{U'^', 6, "073967"},
    Letter{U'_', 6, "0161"},
    Letter{U'`', 2, "0918"},
    Letter{U'a', 6, "6762 6647270603224263"},
    Letter{U'b', 6, "0902 0627476663422203"},
    Letter{U'c', 6, "6647270603224263"},
    Letter{U'd', 6, "6962 6647270603224263"},
    Letter{U'e', 6, "05656647270603224263"},
    Letter{U'f', 4, "49392822 0747"},
    Letter{U'g', 6, "6761402001 6647270603224263"},
    Letter{U'h', 6, "0902 0627476662"},
    Letter{U'i', 2, "1712 19"},
    Letter{U'j', 3, "27211000 29"},
    Letter{U'k', 6, "0902 6704 2562"},
    Letter{U'l', 2, "1912"},
    Letter{U'm', 8, "0702 0617374642 4657778682"},
    Letter{U'n', 6, "0702 0627476662"},
    Letter{U'o', 6, "274766634222030627"},
    Letter{U'p', 6, "0700 0627476663422203"},
    Letter{U'q', 6, "6760 6647270603224263"},
    Letter{U'r', 4, "0702 052747"},
    Letter{U's', 5, "56471706154453421203"},
    Letter{U't', 4, "29233242 0747"},
    Letter{U'u', 6, "0703224263 6762"},
    Letter{U'v', 6, "073267"},
    Letter{U'w', 8, "0722466287"},
    Letter{U'x', 6, "0762 0267"},
    Letter{U'y', 6, "0732 672000"},
    Letter{U'z', 6, "07670262"},
    Letter{U'{', 4, "493928261524223141"},
    Letter{U'|', 2, "1911"},
    Letter{U'}', 4, "091928263524221101"},
    Letter{U'~', 6, "05264465"},
    Letter{U'°', 3, "19293827170819"},
    Letter{U'²', 4, "081939480646"},
    Letter{U'µ', 6, "0700 0703224263 6762"},
    Letter{U'×', 6, "1653 1356"},
    Letter{U'–', 6, "0565"},
    Letter{U'…', 7, "12 42 72"},
};
constexpr Letter kUnknown = {0, 6, "0207676202"};

const Letter& letter_of(char32_t code) {
  const auto* found = std::lower_bound(kLetters.begin(), kLetters.end(), code,
                                       [](const Letter& one, char32_t c) { return one.code < c; });
  return found != kLetters.end() && found->code == code ? *found : kUnknown;
}

// The first letter, which is taken off. A damaged one is 0.
char32_t take_letter(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t bytes = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  const std::string_view letter = text.substr(0, bytes);
  text.remove_prefix(letter.size());
  if (bytes == 1) return first;
  char32_t code = first & (0xFFU >> (bytes + 1));
  for (const char c : letter.substr(1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3FU);
  return letter.size() == bytes ? code : 0;
}

}  // namespace

double text_width(std::string_view utf8, double font_size) {
  int half_units = 0;
  while (!utf8.empty()) half_units += letter_of(take_letter(utf8)).width + kGap;
  return half_units * kAcross * font_size * kCapitalShare / kCapital;
}

std::vector<std::vector<Pixel>> text_lines(std::string_view utf8, Pixel at, double font_size) {
  const double unit = font_size * kCapitalShare / kCapital, across = kAcross * unit;
  std::vector<std::vector<Pixel>> all;
  double x = at.x;
  while (!utf8.empty()) {
    const Letter& letter = letter_of(take_letter(utf8));
    bool begins = true;
    for (std::size_t i = 0; i + 1 < letter.lines.size(); i += 2) {
      if (letter.lines[i] == ' ') begins = true, ++i;
      if (begins) all.emplace_back();
      begins = false;
      all.back().push_back({x + (letter.lines[i] - '0') * across,
                            at.y - (letter.lines[i + 1] - '0' - kBase) * unit});
    }
    x += (letter.width + kGap) * across;
  }
  return all;
}

}  // namespace host
