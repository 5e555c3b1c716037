// What the fuzzers of the file formats have in common.
#pragma once

#include <cstddef>
#include <cstdint>

#include "host/formats/formats.h"  // FileKind

namespace test {

// Reads these bytes as a file of that kind, to its end or to the first error; slices have to be
// clean and stand on one another. Aborts where they do not.
void read_as(host::FileKind kind, const std::uint8_t* data, std::size_t size);

}  // namespace test
