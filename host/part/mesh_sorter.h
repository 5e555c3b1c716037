// Sorts triangles by lowest z in bounded memory: an external merge sort.
//
//     add ──> [ run being filled ] ── full ──> sorted ──> run ▒▒▒▒▒▒
//                                                         run ▒▒▒▒▒▒▒   in one unnamed file
//                                                         run ▒▒▒▒
//     next <── merged, all runs at once, a buffer each <───┘
//
// Nothing is written while all triangles fit the budget. If there are more runs than buffers, runs
// are first merged into longer ones, in as many passes as needed; each pass writes a new file and
// deletes the old one. Triangles with the same lowest z keep their order, so the result does not
// depend on the budget.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"           // Triangle
#include "core/result.h"             // Result, Status
#include "host/part/height_order.h"  // HeightOrder

namespace host {

class TriangleRuns;
class TriangleMerge;

class MeshSorter {
 public:
  struct Options {
    // For runs and buffers together. REQUIRES: >= kSortBytesMin (limits.h)
    std::size_t memory_bytes;
    std::string folder;  // of the temporary file; empty: $TMPDIR, or /tmp
  };

  explicit MeshSorter(const Options& options);
  ~MeshSorter();
  MeshSorter(MeshSorter&&) noexcept;
  MeshSorter& operator=(MeshSorter&&) noexcept;

  // Error if the temporary file can't be made or written.
  // REQUIRES: finish() was not called. COSTS: amortised O(1).
  [[nodiscard]] core::Status add(const core::Triangle& triangle);

  // No triangle follows. COSTS: spill_passes() passes over the file.
  [[nodiscard]] core::Status finish();

  // The next triangle up; nullopt after the last. REQUIRES: finish() was called.
  // COSTS: O(log runs).
  [[nodiscard]] core::Result<std::optional<core::Triangle>> next();

  // Starts again at the lowest triangle. REQUIRES: finish() was called.
  [[nodiscard]] core::Status rewind();

  // Triangles added so far.
  [[nodiscard]] std::int64_t size() const { return size_; }
  // Bytes written so far, in all passes.
  [[nodiscard]] std::int64_t spilled_bytes() const { return spilled_bytes_; }
  // How often every triangle was written.
  [[nodiscard]] int spill_passes() const { return spill_passes_; }

 private:
  [[nodiscard]] core::Status spill();
  [[nodiscard]] core::Status merge_until_few();

  Options options_;
  std::vector<core::Triangle> run_;  // being filled; in the end all of them, if none was written
  HeightOrder order_;                // of run_
  std::size_t next_in_run_ = 0;
  std::unique_ptr<TriangleRuns> runs_;    // null: no run was written
  std::unique_ptr<TriangleMerge> merge_;  // of the last pass
  std::int64_t size_ = 0;
  std::int64_t spilled_bytes_ = 0;
  int spill_passes_ = 0;
  bool finished_ = false;
};

}  // namespace host
