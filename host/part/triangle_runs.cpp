#include "host/part/triangle_runs.h"

#include <algorithm>
#include <utility>

#include "core/check.h"  // RIND_CHECK

namespace host {

TriangleRuns::TriangleRuns(SpillFile file, std::size_t buffer_bytes)
    : file_(std::move(file)), buffer_bytes_(buffer_bytes) {
  buffer_.reserve(buffer_bytes + kTriangleRecordBytesMax);
}

core::Status TriangleRuns::add(const core::Triangle& triangle) {
  write_triangle(triangle, before_, buffer_);
  before_ = triangle.corners[0];
  if (buffer_.size() < buffer_bytes_) return {};
  core::Status written = file_.append(buffer_);
  buffer_.clear();
  return written;
}

core::Status TriangleRuns::end_run() {
  if (core::Status written = file_.append(buffer_); !written.ok()) return written;
  buffer_.clear();
  before_ = {};
  runs_.push_back({run_start_, file_.size()});
  run_start_ = file_.size();
  return {};
}

TriangleMerge::TriangleMerge(const TriangleRuns& runs, std::size_t first, std::size_t last,
                             std::size_t buffer_bytes)
    : runs_(runs), readers_(last - first) {
  RIND_CHECK(buffer_bytes >= kTriangleRecordBytesMax);
  for (std::size_t i = 0; i < readers_.size(); ++i) {
    const TriangleRuns::Run& run = runs.runs()[first + i];
    readers_[i].next = run.begin;
    readers_[i].end = run.end;
    readers_[i].buffer.resize(buffer_bytes);
  }
}

core::Status TriangleMerge::start() {
  for (std::size_t i = 0; i < readers_.size(); ++i) {
    const core::Result<bool> more = advance(readers_[i]);
    if (!more.ok()) return more.error();
    if (more.value()) heap_.push_back(i);
  }
  std::make_heap(heap_.begin(), heap_.end(),
                 [this](std::size_t a, std::size_t b) { return later(a, b); });
  return {};
}

core::Result<bool> TriangleMerge::advance(Reader& reader) const {
  const std::size_t left = reader.filled - reader.used;
  if (left < kTriangleRecordBytesMax && reader.next < reader.end) {
    std::copy_n(reader.buffer.begin() + static_cast<std::ptrdiff_t>(reader.used), left,
                reader.buffer.begin());
    const auto more = static_cast<std::size_t>(std::min<std::int64_t>(
        reader.end - reader.next, static_cast<std::int64_t>(reader.buffer.size() - left)));
    if (core::Status read = runs_.file().read(reader.next, reader.buffer.data() + left, more);
        !read.ok()) {
      return read.error();
    }
    reader.next += static_cast<std::int64_t>(more);
    reader.used = 0;
    reader.filled = left + more;
  }
  if (reader.used == reader.filled) return false;
  const core::Vertex before = reader.triangle.corners[0];
  const char* end = read_triangle(reader.buffer.data() + reader.used, before, reader.triangle);
  reader.lowest_z = reader.triangle.lowest_z();
  reader.used = static_cast<std::size_t>(end - reader.buffer.data());
  return true;
}

// As a rule, the first run stays the first.
void TriangleMerge::sink_first() {
  std::size_t place = 0;
  while (true) {
    std::size_t child = 2 * place + 1;
    if (child >= heap_.size()) return;
    if (child + 1 < heap_.size() && later(heap_[child], heap_[child + 1])) ++child;
    if (!later(heap_[place], heap_[child])) return;
    std::swap(heap_[place], heap_[child]);
    place = child;
  }
}

core::Result<std::optional<core::Triangle>> TriangleMerge::next() {
  if (heap_.empty()) return std::optional<core::Triangle>();
  Reader& reader = readers_[heap_.front()];
  const core::Triangle triangle = reader.triangle;
  const core::Result<bool> more = advance(reader);
  if (!more.ok()) return more.error();
  if (!more.value()) {
    reader.buffer = {};
    heap_.front() = heap_.back();
    heap_.pop_back();
  }
  sink_first();
  return std::optional<core::Triangle>(triangle);
}

}  // namespace host
