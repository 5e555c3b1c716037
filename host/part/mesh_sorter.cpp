#include "host/part/mesh_sorter.h"

#include <algorithm>
#include <utility>

#include "core/check.h"               // RIND_CHECK
#include "host/files/spill_file.h"    // SpillFile
#include "host/part/triangle_runs.h"  // TriangleRuns, TriangleMerge
#include "host/system/limits.h"       // kSortBytesMin

namespace host {
namespace {

constexpr SpillUse kForSorting{"sorting", "set TMPDIR, or more memory with --memory"};

// Buffer of a run that is read or written: a size that suits a disk, less with a small budget.
constexpr std::size_t kBufferBytesMin = std::size_t{4} << 10;
constexpr std::size_t kBufferBytesMax = std::size_t{64} << 10;
constexpr std::size_t kBuffersWanted = 16;

static_assert(kSortBytesMin >= kBuffersWanted * kBufferBytesMin);

std::size_t buffer_bytes(std::size_t memory_bytes) {
  return std::clamp(memory_bytes / kBuffersWanted, kBufferBytesMin, kBufferBytesMax);
}

std::size_t triangles_in_run(std::size_t memory_bytes) {
  return (memory_bytes - buffer_bytes(memory_bytes)) /
         (sizeof(core::Triangle) + HeightOrder::kBytesEach);
}

// Runs that can be merged at once: one buffer is for writing.
std::size_t fan_in(std::size_t memory_bytes) {
  return memory_bytes / buffer_bytes(memory_bytes) - 1;
}

}  // namespace

MeshSorter::MeshSorter(const Options& options) : options_(options) {
  RIND_CHECK(options.memory_bytes >= kSortBytesMin);
}

MeshSorter::~MeshSorter() = default;
MeshSorter::MeshSorter(MeshSorter&&) noexcept = default;
MeshSorter& MeshSorter::operator=(MeshSorter&&) noexcept = default;

core::Status MeshSorter::add(const core::Triangle& triangle) {
  RIND_CHECK(!finished_);
  const std::size_t capacity = triangles_in_run(options_.memory_bytes);
  if (run_.size() == capacity) {
    if (core::Status spilled = spill(); !spilled.ok()) return spilled;
  }
  // Reserved at once, so that growing never holds two copies. Pages are used only as they fill.
  if (run_.capacity() == 0) run_.reserve(capacity);
  run_.push_back(triangle);
  ++size_;
  return {};
}

core::Status MeshSorter::spill() {
  order_.sort(run_);
  if (!runs_) {
    core::Result<SpillFile> file = SpillFile::create(options_.folder, kForSorting);
    if (!file.ok()) return file.error();
    runs_ = std::make_unique<TriangleRuns>(std::move(file).value(),
                                           buffer_bytes(options_.memory_bytes));
    spill_passes_ = 1;
  }
  for (std::size_t i = 0; i < run_.size(); ++i) {
    if (core::Status added = runs_->add(run_[order_[i]]); !added.ok()) return added;
  }
  run_.clear();
  return runs_->end_run();
}

core::Status MeshSorter::finish() {
  RIND_CHECK(!finished_);
  finished_ = true;
  if (!runs_) {
    order_.sort(run_);
    return {};
  }
  if (core::Status spilled = spill(); !spilled.ok()) return spilled;
  run_ = {};
  order_.clear();
  spilled_bytes_ = runs_->file().size();
  if (core::Status merged = merge_until_few(); !merged.ok()) return merged;
  return rewind();
}

core::Status MeshSorter::merge_until_few() {
  const std::size_t buffer = buffer_bytes(options_.memory_bytes);
  const std::size_t at_once = fan_in(options_.memory_bytes);
  while (runs_->runs().size() > at_once) {
    core::Result<SpillFile> file = SpillFile::create(options_.folder, kForSorting);
    if (!file.ok()) return file.error();
    auto longer = std::make_unique<TriangleRuns>(std::move(file).value(), buffer);
    const std::size_t count = runs_->runs().size();
    for (std::size_t first = 0; first < count; first += at_once) {
      TriangleMerge merge(*runs_, first, std::min(count, first + at_once), buffer);
      if (core::Status started = merge.start(); !started.ok()) return started;
      while (true) {
        core::Result<std::optional<core::Triangle>> next = merge.next();
        if (!next.ok()) return next.error();
        if (!next.value()) break;
        if (core::Status added = longer->add(*next.value()); !added.ok()) return added;
      }
      if (core::Status ended = longer->end_run(); !ended.ok()) return ended;
    }
    spilled_bytes_ += longer->file().size();
    ++spill_passes_;
    runs_ = std::move(longer);
  }
  return {};
}

core::Status MeshSorter::rewind() {
  RIND_CHECK(finished_);
  next_in_run_ = 0;
  if (!runs_) return {};
  merge_ = std::make_unique<TriangleMerge>(*runs_, 0, runs_->runs().size(),
                                           buffer_bytes(options_.memory_bytes));
  return merge_->start();
}

core::Result<std::optional<core::Triangle>> MeshSorter::next() {
  RIND_CHECK(finished_);
  if (merge_) return merge_->next();
  if (next_in_run_ == run_.size()) return std::optional<core::Triangle>();
  return std::optional<core::Triangle>(run_[order_[next_in_run_++]]);
}

}  // namespace host
