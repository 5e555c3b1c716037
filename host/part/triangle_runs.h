// Sorted runs of triangles in one unnamed file, and their merging.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry.h"              // Triangle, Vertex
#include "core/result.h"                // Result, Status
#include "host/files/spill_file.h"      // SpillFile
#include "host/part/triangle_record.h"  // kTriangleRecordBytesMax

namespace host {

// Writes runs one after the other into one file.
class TriangleRuns {
 public:
  struct Run {
    std::int64_t begin = 0;  // bytes in the file
    std::int64_t end = 0;
  };

  TriangleRuns(SpillFile file, std::size_t buffer_bytes);

  // Appends to the run that is being written. REQUIRES: in order.
  [[nodiscard]] core::Status add(const core::Triangle& triangle);
  [[nodiscard]] core::Status end_run();

  [[nodiscard]] const std::vector<Run>& runs() const { return runs_; }
  [[nodiscard]] const SpillFile& file() const { return file_; }

 private:
  SpillFile file_;
  std::size_t buffer_bytes_;
  std::string buffer_;
  core::Vertex before_;  // first corner of the last triangle of the run
  std::int64_t run_start_ = 0;
  std::vector<Run> runs_;
};

// Merges some of the runs: gives their triangles, the lowest first, of equally low ones those of
// the run that was written first.
class TriangleMerge {
 public:
  // Runs `first` … `last` - 1. REQUIRES: the runs outlive this; buffer_bytes holds a record.
  TriangleMerge(const TriangleRuns& runs, std::size_t first, std::size_t last,
                std::size_t buffer_bytes);

  // REQUIRES: called once, before the first next().
  [[nodiscard]] core::Status start();
  [[nodiscard]] core::Result<std::optional<core::Triangle>> next();

 private:
  struct Reader {
    std::int64_t next = 0;  // not yet in the buffer
    std::int64_t end = 0;
    std::vector<char> buffer;
    std::size_t used = 0;
    std::size_t filled = 0;
    core::Triangle triangle;
    std::int64_t lowest_z = 0;
  };

  [[nodiscard]] bool later(std::size_t a, std::size_t b) const {
    return readers_[a].lowest_z != readers_[b].lowest_z
               ? readers_[a].lowest_z > readers_[b].lowest_z
               : a > b;
  }
  // Puts the first of the heap where it belongs.
  void sink_first();
  // False at the run's end.
  [[nodiscard]] core::Result<bool> advance(Reader& reader) const;

  const TriangleRuns& runs_;
  std::vector<Reader> readers_;
  std::vector<std::size_t> heap_;  // readers with triangles left, the one with the lowest in front
};

}  // namespace host
