#include "firmware_link/wire/capabilities.h"

namespace firmware_link {
namespace {

struct Name {
  std::string_view name;
  bool Capabilities::*member;
};

constexpr Name kNames[] = {{"AUTOREPORT_TEMP", &Capabilities::autoreport_temperatures},
                           {"EMERGENCY_PARSER", &Capabilities::emergency_parser},
                           {"HOST_ACTION_COMMANDS", &Capabilities::host_actions},
                           {"ARCS", &Capabilities::arcs},
                           {"MEATPACK", &Capabilities::meatpack}};

}  // namespace

void note_capability(std::string_view text, Capabilities& capabilities) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return;
  for (const Name& known : kNames) {
    if (text.substr(0, colon) == known.name) {
      capabilities.*known.member = text.substr(colon + 1, 1) == "1";
    }
  }
}

void note_travel(std::string_view line, Capabilities& capabilities) {
  const std::optional<TravelLimits> told = travel_limits_in(line);
  if (!told) return;
  if (told == capabilities.travel_told_last) capabilities.travel = told;
  capabilities.travel_told_last = told;
}

namespace {

// What stands before the next " WORD:", or at the end.
std::string value_before_next_word(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  for (std::size_t blank = text.find(' '); blank != std::string_view::npos;
       blank = text.find(' ', blank + 1)) {
    std::size_t end = blank + 1;
    while (end < text.size() && ((text[end] >= 'A' && text[end] <= 'Z') || text[end] == '_')) ++end;
    if (end > blank + 1 && end < text.size() && text[end] == ':') {
      return std::string(text.substr(0, blank));
    }
  }
  return std::string(text);
}

}  // namespace

std::string firmware_name_in(std::string_view text) { return value_before_next_word(text); }

std::string machine_type_in(std::string_view text) {
  constexpr std::string_view kWord = "MACHINE_TYPE:";
  const std::size_t at = text.find(kWord);
  return at == std::string_view::npos ? "" : value_before_next_word(text.substr(at + kWord.size()));
}

}  // namespace firmware_link
