#include "host/mesh_layers.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/limits.h"       // kCoordinateMax
#include "core/plane_sweep.h"  // PlaneSweep, layer_count
#include "host/mesh_sorter.h"  // MeshSorter
#include "host/stage_clock.h"  // thread_cpu_seconds

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Length;
using core::Result;
using core::Status;
using core::Triangle;

// So many triangles are read, then sorted, between two looks at the clock.
constexpr std::size_t kBatchTriangles = 1024;

// Adds the processor time of its own life.
class CpuTimer {
 public:
  explicit CpuTimer(double& seconds) : seconds_(seconds), begin_s_(thread_cpu_seconds()) {}
  ~CpuTimer() { seconds_ += thread_cpu_seconds() - begin_s_; }
  CpuTimer(const CpuTimer&) = delete;
  CpuTimer& operator=(const CpuTimer&) = delete;

 private:
  double& seconds_;
  double begin_s_;
};

// "12.3", without zeros at the end.
std::string mm_text(std::int64_t units) {
  std::string text = units < 0 ? "-" : "";
  const std::uint64_t size =
      units < 0 ? 0 - static_cast<std::uint64_t>(units) : static_cast<std::uint64_t>(units);
  const auto per_mm = static_cast<std::uint64_t>(core::kUnitsPerMm);
  text += std::to_string(size / per_mm);
  std::string rest = std::to_string(per_mm + size % per_mm).substr(1);
  rest.erase(rest.find_last_not_of('0') + 1);
  return rest.empty() ? text : text + "." + rest;
}

// Where a mesh is, before it is set on the bed.
struct Extent {
  core::Box box;
  std::int64_t lowest_z = std::numeric_limits<std::int64_t>::max();
  std::int64_t highest_z = std::numeric_limits<std::int64_t>::min();

  void add(const Triangle& triangle) {
    for (const core::Vertex& corner : triangle.corners) box.add(core::Point{corner.x, corner.y});
    lowest_z = std::min(lowest_z, triangle.lowest_z());
    highest_z = std::max(highest_z, triangle.highest_z());
  }
};

struct Shift {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t z = 0;
};

core::Point shifted(core::Point p, const Shift& shift) {
  return {static_cast<std::int32_t>(p.x + shift.x), static_cast<std::int32_t>(p.y + shift.y)};
}

Shift shift_to_bed(const Extent& extent, const core::Settings& settings) {
  const core::Box& box = extent.box;
  if (!settings.centre) {
    return {settings.part_x.units() - box.min.x, settings.part_y.units() - box.min.y,
            -extent.lowest_z};
  }
  // Doubled, so that halves are rounded once; the sums stay below 2^32.
  const auto centred = [](std::int64_t bed, std::int64_t low, std::int64_t high) {
    return (bed - low - high) / 2;
  };
  return {centred(settings.bed_x.units(), box.min.x, box.max.x),
          centred(settings.bed_y.units(), box.min.y, box.max.y), -extent.lowest_z};
}

// One mesh: read to its end at birth, then sliced from the bed up.
class MeshLayers : public LayerSource {
 public:
  MeshLayers(std::unique_ptr<TriangleSource> reader, std::string name,
             const core::Settings& settings)
      : reader_(std::move(reader)), name_(std::move(name)), settings_(settings) {}

  [[nodiscard]] Status prepare() {
    if (Status read = read_all(); !read.ok()) return read;
    {
      const CpuTimer timer(counters_.sort_cpu_s);
      if (Status sorted = sorter_.finish(); !sorted.ok()) return sorted;
    }
    if (Status placed = place(); !placed.ok()) return placed;
    const core::PlaneSweep::Options options{settings_.layer_height, summary_.layers,
                                            settings_.simplify_tolerance, settings_.chain_gap_max};
    sweep_.emplace(options, [this] { return next_triangle(); });
    reader_.reset();
    return {};
  }

  [[nodiscard]] Result<std::optional<core::Slice>> next() override {
    const double begin_s = thread_cpu_seconds(), sort_before_s = counters_.sort_cpu_s;
    Result<std::optional<core::Slice>> slice = sweep_->next();
    const double sorted_s = counters_.sort_cpu_s - sort_before_s;
    counters_.slice_cpu_s += thread_cpu_seconds() - begin_s - sorted_s;
    counters_.peak_triangles_held = sweep_->peak_triangles_held();
    return slice;
  }

  [[nodiscard]] const PartSummary& summary() const { return summary_; }
  [[nodiscard]] const PartCounters& counters() const { return counters_; }

 private:
  [[nodiscard]] Status read_all() {
    std::vector<Triangle> batch;
    batch.reserve(kBatchTriangles);
    bool more = true;
    while (more) {
      batch.clear();
      {
        const CpuTimer timer(counters_.read_cpu_s);
        while (more && batch.size() < kBatchTriangles) {
          Result<std::optional<Triangle>> triangle = reader_->next();
          if (!triangle.ok()) return triangle.error();
          more = triangle.value().has_value();
          if (more && is_needed(*triangle.value())) batch.push_back(*triangle.value());
        }
      }
      const CpuTimer timer(counters_.sort_cpu_s);
      for (const Triangle& triangle : batch) {
        if (Status added = sorter_.add(triangle); !added.ok()) return added;
      }
    }
    summary_.format = reader_->format();
    summary_.facets = reader_->facets();
    summary_.warnings = reader_->warnings();
    return {};
  }

  // Horizontal facets are crossed by no plane.
  [[nodiscard]] bool is_needed(const Triangle& triangle) {
    extent_.add(triangle);
    const auto& [a, b, c] = triangle.corners;
    if (a == b || b == c || c == a) {
      ++summary_.degenerate;
      return false;
    }
    if (triangle.lowest_z() == triangle.highest_z()) return false;
    highest_cut_ = std::max(highest_cut_, triangle.highest_z());
    return true;
  }

  [[nodiscard]] Error refused(ErrorCode code, const std::string& cause) const {
    return {code, name_ + ": " + cause};
  }

  [[nodiscard]] Status place() {
    if (sorter_.size() == 0) {
      return refused(ErrorCode::kBadPart,
                     "the part is flat, it has no height; export it as a solid");
    }
    summary_.height = Length::from_units(highest_cut_ - extent_.lowest_z);
    summary_.layers = core::layer_count(summary_.height, settings_.layer_height);
    if (summary_.layers == 0) {
      return refused(ErrorCode::kBadPart, "the part is " + mm_text(summary_.height.units()) +
                                              " mm high, less than half a layer of " +
                                              mm_text(settings_.layer_height.units()) +
                                              " mm; check its unit, or lower layer_height");
    }
    shift_ = shift_to_bed(extent_, settings_);
    if (Status fits = check_bed(); !fits.ok()) return fits;
    summary_.box = {shifted(extent_.box.min, shift_), shifted(extent_.box.max, shift_)};
    return {};
  }

  [[nodiscard]] Status check_bed() const {
    const core::Box& box = extent_.box;
    const std::int64_t left = box.min.x + shift_.x, right = box.max.x + shift_.x;
    const std::int64_t front = box.min.y + shift_.y, back = box.max.y + shift_.y;
    const std::int64_t bed_x = settings_.bed_x.units(), bed_y = settings_.bed_y.units();
    const std::string bed = mm_text(bed_x) + " × " + mm_text(bed_y) + " mm";
    if (right - left > bed_x || back - front > bed_y) {
      return refused(ErrorCode::kOutOfBounds, "the part is " + mm_text(right - left) + " × " +
                                                  mm_text(back - front) + " mm, the bed " + bed +
                                                  "; scale the part, or check bed_x and bed_y");
    }
    if (left < 0 || front < 0 || right > bed_x || back > bed_y) {
      return refused(ErrorCode::kOutOfBounds, "the part would lie at " + mm_text(left) + " … " +
                                                  mm_text(right) + ", " + mm_text(front) + " … " +
                                                  mm_text(back) + " mm on a bed of " + bed +
                                                  "; change part_x and part_y, or centre it");
    }
    if (right > core::kCoordinateMax || back > core::kCoordinateMax) {
      return refused(ErrorCode::kOutOfBounds, "the part would lie farther than " +
                                                  mm_text(core::kCoordinateMax) +
                                                  " mm from the bed's corner; move it");
    }
    const Length axis = settings_.axis_z;
    if (axis.units() != 0 && summary_.height > axis) {
      return refused(ErrorCode::kOutOfBounds, "the part is " + mm_text(summary_.height.units()) +
                                                  " mm high, the axis " + mm_text(axis.units()) +
                                                  " mm; scale the part, or check axis_z");
    }
    return {};
  }

  // From a batch, so that the clock is not looked at for each.
  [[nodiscard]] Result<std::optional<Triangle>> next_triangle() {
    if (next_in_batch_ == batch_.size()) {
      const CpuTimer timer(counters_.sort_cpu_s);
      batch_.clear();
      next_in_batch_ = 0;
      while (batch_.size() < kBatchTriangles) {
        Result<std::optional<Triangle>> triangle = sorter_.next();
        if (!triangle.ok()) return triangle.error();
        if (!triangle.value()) break;
        batch_.push_back(*triangle.value());
      }
      if (batch_.empty()) return std::optional<Triangle>();
    }
    Triangle triangle = batch_[next_in_batch_++];
    for (core::Vertex& corner : triangle.corners) {
      const core::Point p = shifted({corner.x, corner.y}, shift_);
      corner = {p.x, p.y, corner.z + shift_.z};
    }
    return std::optional<Triangle>(triangle);
  }

  std::unique_ptr<TriangleSource> reader_;
  std::string name_;
  core::Settings settings_;
  PartSummary summary_;
  PartCounters counters_;
  MeshSorter sorter_;
  Extent extent_;
  std::int64_t highest_cut_ = std::numeric_limits<std::int64_t>::min();
  Shift shift_;
  std::vector<Triangle> batch_;
  std::size_t next_in_batch_ = 0;
  std::optional<core::PlaneSweep> sweep_;
};

}  // namespace

Result<OpenedPart> open_mesh(MeshInput mesh, const core::Settings& settings) {
  auto layers = std::make_unique<MeshLayers>(std::move(mesh.triangles), mesh.name, settings);
  if (Status prepared = layers->prepare(); !prepared.ok()) return prepared.error();
  OpenedPart part;
  part.summary = layers->summary();
  part.counters = [source = layers.get()] { return source->counters(); };
  part.layers = std::move(layers);
  return part;
}

}  // namespace host
