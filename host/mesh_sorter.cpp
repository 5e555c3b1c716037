#include "host/mesh_sorter.h"

#include <algorithm>

#include "core/check.h"  // RIND_CHECK

namespace host {
namespace {

bool lower(const core::Triangle& a, const core::Triangle& b) {
  const std::int64_t za = a.lowest_z(), zb = b.lowest_z();
  return za != zb ? za < zb : a.corners < b.corners;
}

}  // namespace

MeshSorter::MeshSorter(std::size_t run_triangles) : run_triangles_(run_triangles) {
  RIND_CHECK(run_triangles > 0);
}

void MeshSorter::sort_last_run() {
  if (!runs_.empty())
    std::sort(runs_.back().triangles.begin(), runs_.back().triangles.end(), lower);
}

core::Status MeshSorter::add(const core::Triangle& triangle) {
  RIND_CHECK(!finished_);
  if (runs_.empty() || runs_.back().triangles.size() == run_triangles_) {
    sort_last_run();
    runs_.emplace_back();
  }
  runs_.back().triangles.push_back(triangle);
  ++size_;
  return {};
}

bool MeshSorter::comes_later(std::size_t run_a, std::size_t run_b) const {
  const Run& a = runs_[run_a];
  const Run& b = runs_[run_b];
  return lower(b.triangles[b.next], a.triangles[a.next]);
}

core::Status MeshSorter::finish() {
  RIND_CHECK(!finished_);
  finished_ = true;
  sort_last_run();
  for (std::size_t i = 0; i < runs_.size(); ++i) heap_.push_back(i);
  std::make_heap(heap_.begin(), heap_.end(),
                 [this](std::size_t a, std::size_t b) { return comes_later(a, b); });
  return {};
}

core::Result<std::optional<core::Triangle>> MeshSorter::next() {
  RIND_CHECK(finished_);
  if (heap_.empty()) return std::optional<core::Triangle>();
  const auto later = [this](std::size_t a, std::size_t b) { return comes_later(a, b); };
  std::pop_heap(heap_.begin(), heap_.end(), later);
  Run& run = runs_[heap_.back()];
  const core::Triangle triangle = run.triangles[run.next++];
  if (run.next < run.triangles.size()) {
    std::push_heap(heap_.begin(), heap_.end(), later);
  } else {
    run = Run();
    heap_.pop_back();
  }
  return std::optional<core::Triangle>(triangle);
}

}  // namespace host
