// Small files of every kind, and how tests read files out of memory.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/geometry.h"      // Triangle
#include "core/result.h"        // Result
#include "core/slices/slice.h"  // Slice

namespace test {

struct FormatSample {
  std::string name;
  std::string bytes;
};

// One valid file of each kind that is read, a few layers or facets each: seeds for fuzzers, and
// what is cut and damaged in tests.
const std::vector<FormatSample>& format_samples();
const std::string& format_sample(const std::string& name);

// Whatever it is: detected, read to its end, as far as it goes.
struct ReadFile {
  std::string format;
  std::vector<core::Slice> slices;        // of a layer file
  std::vector<core::Triangle> triangles;  // of a mesh
  std::vector<std::string> warnings;
};
// At most `most` slices or triangles; more are an error of the test's own.
core::Result<ReadFile> read_bytes(const std::string& bytes, std::size_t most = 100'000);

// The message; empty where the file is fine.
std::string error_of(const std::string& bytes);

// Binary files, number by number.
void append_u16(unsigned number, std::string& into);
void append_u32(std::uint32_t number, std::string& into);
void append_float(float number, std::string& into);

}  // namespace test
