#include "tests/support/name_rules.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <string_view>

#include "tests/support/source_text.h"  // code_only, lines_of

namespace test {
namespace {

using Names = std::set<std::string, std::less<>>;

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool is_code(const std::string& path) { return path.ends_with(".h") || path.ends_with(".cpp"); }

// Calls `found` with each run of characters for which `belongs` holds, and what follows it.
template <typename Belongs, typename Found>
void for_each_run(std::string_view text, Belongs belongs, Found found) {
  for (std::size_t i = 0; i < text.size();) {
    if (!belongs(text[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && belongs(text[end])) ++end;
    found(text.substr(i, end - i), text.substr(end));
    i = end;
  }
}

Names identifiers_of(const std::vector<Source>& sources) {
  Names names;
  for (const Source& source : sources) {
    if (!is_code(source.path)) continue;
    for_each_run(code_only(source.text), is_letter,
                 [&](std::string_view word, std::string_view) { names.emplace(word); });
  }
  return names;
}

// Paths, and every end of them that begins behind a '/'.
Names ends_of_paths(const std::vector<Source>& sources) {
  Names ends;
  for (const Source& source : sources) {
    const std::string_view path = source.path;
    ends.emplace(path);
    for (std::size_t i = path.find('/'); i != std::string_view::npos; i = path.find('/', i + 1)) {
      ends.emplace(path.substr(i + 1));
    }
  }
  return ends;
}

// The comment that ends the line; empty: there is none. A "//" in a string is none of them.
std::string_view comment_of(std::string_view line) {
  const std::size_t at = line.find("//");
  if (at == std::string_view::npos) return {};
  const std::string_view before = line.substr(0, at);
  return before.find('"') == std::string_view::npos ? line.substr(at + 2) : std::string_view();
}

// Words in capitals are a file format's.
bool is_function(std::string_view word) {
  return std::any_of(word.begin(), word.end(),
                     [](char c) { return std::islower(static_cast<unsigned char>(c)) != 0; });
}

bool is_constant(std::string_view word) {
  return word.size() > 2 && word[0] == 'k' &&
         std::isupper(static_cast<unsigned char>(word[1])) != 0;
}

bool is_file(std::string_view word) { return word.ends_with(".h") || word.ends_with(".cpp"); }

}  // namespace

Complaints check_named_in_comments(const std::vector<Source>& sources) {
  const Names identifiers = identifiers_of(sources), paths = ends_of_paths(sources);
  Complaints complaints;
  for (const Source& source : sources) {
    if (!is_code(source.path)) continue;
    const std::vector<std::string> lines = lines_of(source.text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto complain = [&](std::string_view word) {
        complaints.push_back(source.path + ":" + std::to_string(i + 1) + ": names " +
                             std::string(word) + ", which does not exist");
      };
      const std::string_view comment = comment_of(lines[i]);
      for_each_run(comment, is_letter, [&](std::string_view word, std::string_view behind) {
        const bool named = is_constant(word) || (is_function(word) && behind.starts_with("()"));
        if (named && !identifiers.contains(word)) complain(word);
      });
      const auto in_path = [](char c) { return is_letter(c) || c == '/' || c == '.'; };
      for_each_run(comment, in_path, [&](std::string_view word, std::string_view) {
        while (word.ends_with('.')) word.remove_suffix(1);
        if (is_file(word) && word != ".h" && word != ".cpp" && !paths.contains(word))
          complain(word);
      });
    }
  }
  return complaints;
}

}  // namespace test
