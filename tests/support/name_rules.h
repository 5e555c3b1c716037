// Checks that files, functions and constants named in comments exist.
#pragma once

#include <vector>

#include "tests/support/source_rules.h"  // Complaints, Source

namespace test {

// In each comment in C++ code:
//     a header or source         a file whose path ends so
//     a name before "()"         an identifier somewhere in the code
//     a constant, k and capital  the same
// COSTS: reads all text twice.
Complaints check_named_in_comments(const std::vector<Source>& sources);

}  // namespace test
