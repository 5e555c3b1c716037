// Branches in a temporary file come back as they were.
#include "host/part/branch_bytes.h"

#include <doctest/doctest.h>

#include <cstdint>

TEST_CASE("branches come back as they were") {
  CHECK(host::branches_in(host::branch_bytes({})).empty());
  const core::Branches branches = {{{1, 2}, {3, 4}, false, false},
                                   {{-5, INT32_MAX}, {INT32_MIN, 0}, true, false},
                                   {{7, 8}, {9, 10}, false, true},
                                   {{7, 8}, {9, 11}, true, true}};
  CHECK(host::branches_in(host::branch_bytes(branches)) == branches);
}
