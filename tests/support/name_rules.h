// What comments name has to exist: files, functions, constants.
#pragma once

#include <vector>

#include "tests/support/source_rules.h"  // Complaints, Source

namespace test {

// Of each comment in C++ code:
//     a header or source         a file whose path ends so
//     a name before "()"         an identifier somewhere in the code
//     a constant, k and capital  the same
// COSTS: all text twice.
Complaints check_named_in_comments(const std::vector<Source>& sources);

}  // namespace test
