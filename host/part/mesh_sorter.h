// Triangles in, in any order; the same triangles out in order of lowest z, in bounded memory.
//
//     add ──> [ run being filled ] ── full ──> sorted ──> run ▒▒▒▒▒▒
//                                                         run ▒▒▒▒▒▒▒   in one unnamed file
//                                                         run ▒▒▒▒
//     next <── merged, all runs at once, a buffer each <───┘
//
// As long as all fits the budget nothing is written. With more runs than there are buffers, runs
// are merged into longer ones first, as often as it takes: each pass writes a new file and gives
// the old one back. Triangles of equal lowest z come in the order of their corners, so that what
// comes out depends neither on the order in the file nor on the budget.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"  // Triangle
#include "core/result.h"    // Result, Status

namespace host {

class TriangleRuns;
class TriangleMerge;

class MeshSorter {
 public:
  struct Options {
    // Runs, buffers and all. REQUIRES: >= kSortBytesMin (limits.h)
    std::size_t memory_bytes;
    std::string folder;  // of the file; empty: $TMPDIR, or /tmp
  };

  explicit MeshSorter(const Options& options);
  ~MeshSorter();
  MeshSorter(MeshSorter&&) noexcept;
  MeshSorter& operator=(MeshSorter&&) noexcept;

  // Fails when the file can't be made or written.
  // REQUIRES: finish() was not called. COSTS: amortised O(log of a run).
  [[nodiscard]] core::Status add(const core::Triangle& triangle);

  // No triangle follows. COSTS: as many passes over the file as spill_passes() tells then.
  [[nodiscard]] core::Status finish();

  // The next one up, or nothing when all have left. REQUIRES: finish() was called.
  // COSTS: O(log runs).
  [[nodiscard]] core::Result<std::optional<core::Triangle>> next();

  // Begins anew at the lowest. REQUIRES: finish() was called.
  [[nodiscard]] core::Status rewind();

  // Taken so far.
  [[nodiscard]] std::int64_t size() const { return size_; }
  // Written so far, all passes together.
  [[nodiscard]] std::int64_t spilled_bytes() const { return spilled_bytes_; }
  // How often every triangle was written.
  [[nodiscard]] int spill_passes() const { return spill_passes_; }

 private:
  [[nodiscard]] core::Status spill();
  [[nodiscard]] core::Status merge_until_few();

  Options options_;
  std::vector<core::Triangle> run_;  // being filled; later all, where nothing was written
  std::size_t next_in_run_ = 0;
  std::unique_ptr<TriangleRuns> runs_;    // nothing: not a run was written
  std::unique_ptr<TriangleMerge> merge_;  // of the last pass
  std::int64_t size_ = 0;
  std::int64_t spilled_bytes_ = 0;
  int spill_passes_ = 0;
  bool finished_ = false;
};

}  // namespace host
