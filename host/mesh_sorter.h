// Triangles in, in any order; the same triangles out in order of lowest z.
//
// They are kept in runs of fixed size, each sorted when it is full, and the runs are merged on the
// way out. Triangles of equal lowest z come in the order of their corners, so that what comes out
// does not depend on the order in the file. Runs are in memory; add() and finish() can fail
// because runs are to be written to a file some day.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry.h"  // Triangle
#include "core/result.h"    // Result, Status

namespace host {

class MeshSorter {
 public:
  // Triangles in a run: 3 MiB.
  static constexpr std::size_t kRunTriangles = std::size_t{1} << 16;

  explicit MeshSorter(std::size_t run_triangles = kRunTriangles);

  // REQUIRES: finish() was not called. COSTS: amortised O(log kRunTriangles), 48 bytes.
  [[nodiscard]] core::Status add(const core::Triangle& triangle);

  // No triangle follows.
  [[nodiscard]] core::Status finish();

  // The next one up, or nothing when all have left. A run's memory is given back with its last
  // triangle. REQUIRES: finish() was called. COSTS: O(log runs).
  [[nodiscard]] core::Result<std::optional<core::Triangle>> next();

  // Taken so far.
  [[nodiscard]] std::int64_t size() const { return size_; }

 private:
  struct Run {
    std::vector<core::Triangle> triangles;
    std::size_t next = 0;
  };

  void sort_last_run();
  [[nodiscard]] bool comes_later(std::size_t run_a, std::size_t run_b) const;

  std::size_t run_triangles_;
  std::vector<Run> runs_;
  std::vector<std::size_t> heap_;  // runs with triangles left, the one with the lowest in front
  std::int64_t size_ = 0;
  bool finished_ = false;
};

}  // namespace host
