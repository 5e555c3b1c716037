// The mechanical part of the house's rules, as functions from a source's text to complaints.
//
// A complaint is "path:line: what is wrong". tests/tidy_test.cpp runs them over the sources, and
// over small bad texts, to show that each of them can fail.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace test {

struct Source {
  std::string path;  // from the repository's root: "core/units.h"
  std::string text;
};

using Complaints = std::vector<std::string>;

// Lines up to 100 columns (code points, not bytes), files up to 400 lines.
Complaints check_size(const Source& source);

// Functions up to 70 lines, from the first line of their head to the closing brace. Test cases are
// functions too. REQUIRES: code that compiles and was formatted.
Complaints check_functions(const Source& source);

// Words that promise work for later, and names of the machine that this was written on.
Complaints check_words(const Source& source);

// Each header guards itself with #pragma once.
Complaints check_guard(const Source& source);

// The arrows between the rooms, who may include which library, and what core and firmware_link do
// without: files, threads.
Complaints check_includes(const Source& source);

// Inside a library a folder includes only folders below it, in the order that stands in
// source_rules.cpp and in the library's README.
Complaints check_floors(const Source& source);

// Nobody in core or firmware_link asks what time it is, for they are told, nor prints.
Complaints check_calls(const Source& source);

// Headers that no other file includes.
Complaints check_dead_headers(const std::vector<Source>& sources);

}  // namespace test
