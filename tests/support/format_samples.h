// Small files of every kind, and functions that read files from memory.
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

// One valid file of each kind that is read, each with a few layers or facets: seeds for fuzzers,
// and for tests that cut and damage files.
const std::vector<FormatSample>& format_samples();
const std::string& format_sample(const std::string& name);

// Recognises the kind and reads the file to its end, or to the first error.
struct ReadFile {
  std::string format;
  std::vector<core::Slice> slices;        // of a layer file
  std::vector<core::Triangle> triangles;  // of a mesh
  std::vector<std::string> warnings;
};
// Reads at most `most` slices or triangles; more are an error.
core::Result<ReadFile> read_bytes(const std::string& bytes, std::size_t most = 100'000);

// The error message; empty if the file is fine.
std::string error_of(const std::string& bytes);

// Binary files, number by number.
void append_u16(unsigned number, std::string& into);
void append_u32(std::uint32_t number, std::string& into);
void append_float(float number, std::string& into);

}  // namespace test
