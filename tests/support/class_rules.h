// How much a class holds.
#pragma once

#include "tests/support/source_rules.h"  // Complaints, Source

namespace test {

// Classes and structs have up to 25 data members, nested ones counted by themselves. Tables of
// values that a user sets, one member a row, are left out: core::Settings and PrintSettings.
// REQUIRES: code that compiles and was formatted.
Complaints check_members(const Source& source);

}  // namespace test
