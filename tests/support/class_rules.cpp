#include "tests/support/class_rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/source_text.h"  // code_only

namespace test {
namespace {

constexpr std::size_t kMembersMax = 25;
constexpr std::array<std::string_view, 2> kTables = {"Settings", "PrintSettings"};

// Stands for what was in braces and is no declaration of this class: a body, an initialiser.
constexpr char kBlock = '\x01';

// The declarations of the class whose brace opens at `open`, without what is in inner braces.
std::string own_text(const std::string& code, std::size_t open) {
  std::string text;
  std::size_t depth = 1;
  for (std::size_t i = open + 1; i < code.size() && depth > 0; ++i) {
    if (code[i] == '{') ++depth;
    if (code[i] == '}' && --depth == 1) text += kBlock;
    if (depth == 1 && code[i] != '}') text += code[i];
  }
  return text;
}

// Without template arguments, in which commas and parentheses mean something else.
std::string without_arguments(std::string text) {
  static const std::regex kArguments("<[^<>]*>");
  for (std::string before; before != text;) {
    before = text;
    text = std::regex_replace(text, kArguments, "");
  }
  return text;
}

// At ';', and behind a function's body, which has none.
std::vector<std::string> declarations_of(const std::string& text) {
  std::vector<std::string> all(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t next = text.find_first_not_of(" \n", i + 1);
    const bool body = text[i] == kBlock && (next == std::string::npos ||
                                            std::isalpha(static_cast<unsigned char>(text[next])) ||
                                            text[next] == '[' || text[next] == '~');
    if (text[i] == ';' || body) {
      all.emplace_back();
    } else if (text[i] != kBlock) {
      all.back() += text[i];
    }
  }
  return all;
}

std::size_t members_in(const std::string& declaration) {
  static const std::regex kAccess("\\b(public|private|protected)\\s*:");
  static const std::regex kOther(
      "^\\s*(using|enum|static|friend|typedef|struct|class|template|#)\\b");
  const std::string text = std::regex_replace(declaration, kAccess, "");
  const bool blank = text.find_first_not_of(" \n") == std::string::npos;
  if (blank || text.find('(') != std::string::npos || std::regex_search(text, kOther)) return 0;
  return 1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), ','));
}

}  // namespace

Complaints check_members(const Source& source) {
  static const std::regex kClass("\\b(class|struct)\\s+(\\w+)[^;{}()=]*\\{");
  Complaints complaints;
  if (!source.path.ends_with(".h") && !source.path.ends_with(".cpp")) return complaints;
  const std::string code = code_only(source.text);
  for (std::sregex_iterator at(code.begin(), code.end(), kClass), end; at != end; ++at) {
    const std::string name = (*at)[2];
    if (std::find(kTables.begin(), kTables.end(), name) != kTables.end()) continue;
    const auto start = static_cast<std::size_t>(at->position(0));
    if (code.substr(start < 5 ? 0 : start - 5, 5) == "enum ") continue;
    const std::size_t open = start + static_cast<std::size_t>(at->length(0)) - 1;
    std::size_t count = 0;
    for (const std::string& one : declarations_of(without_arguments(own_text(code, open)))) {
      count += members_in(one);
    }
    if (count <= kMembersMax) continue;
    const auto line = 1 + std::count(code.begin(), code.begin() + at->position(0), '\n');
    complaints.push_back(source.path + ":" + std::to_string(line) + ": " + name + " has " +
                         std::to_string(count) + " data members");
  }
  return complaints;
}

}  // namespace test
