// The common part of the file formats' fuzzers.
#pragma once

#include <cstddef>
#include <cstdint>

#include "host/formats/formats.h"  // FileKind

namespace test {

// Reads these bytes as a file of that kind, to its end or to the first error. Aborts if slices are
// not clean or don't lie on one another.
void read_as(host::FileKind kind, const std::uint8_t* data, std::size_t size);

}  // namespace test
