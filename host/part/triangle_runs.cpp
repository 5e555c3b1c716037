#include "host/part/triangle_runs.h"

#include <algorithm>

#include "core/check.h"  // RIND_CHECK

namespace host {

bool lower(const core::Triangle& a, const core::Triangle& b) {
  const std::int64_t za = a.lowest_z(), zb = b.lowest_z();
  return za != zb ? za < zb : a.corners < b.corners;
}

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
  std::make_heap(heap_.begin(), heap_.end(), [this](std::size_t a, std::size_t b) {
    return lower(readers_[b].triangle, readers_[a].triangle);
  });
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
  reader.used = static_cast<std::size_t>(end - reader.buffer.data());
  return true;
}

core::Result<std::optional<core::Triangle>> TriangleMerge::next() {
  if (heap_.empty()) return std::optional<core::Triangle>();
  const auto later = [this](std::size_t a, std::size_t b) {
    return lower(readers_[b].triangle, readers_[a].triangle);
  };
  std::pop_heap(heap_.begin(), heap_.end(), later);
  Reader& reader = readers_[heap_.back()];
  const core::Triangle triangle = reader.triangle;
  const core::Result<bool> more = advance(reader);
  if (!more.ok()) return more.error();
  if (more.value()) {
    std::push_heap(heap_.begin(), heap_.end(), later);
  } else {
    reader.buffer = {};
    heap_.pop_back();
  }
  return std::optional<core::Triangle>(triangle);
}

}  // namespace host
