#include "host/part/mesh_layers.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/slices/height_plan.h"   // layer_heights
#include "core/slices/plane_sweep.h"   // PlaneSweep
#include "host/part/bed_placing.h"     // shift_to_bed, check_on_bed
#include "host/part/height_check.h"    // check_height
#include "host/part/mesh_piece.h"      // MeshPiece, check_size
#include "host/part/mesh_sorter.h"     // MeshSorter
#include "host/part/mesh_summary.h"    // summarise_file
#include "host/part/mesh_survey.h"     // MeshSurvey
#include "host/part/part_heights.h"    // part_heights
#include "host/part/plane_check.h"     // check_planes
#include "host/part/reorder_window.h"  // OrderGauge, ReorderWindow
#include "host/system/stage_clock.h"   // CpuTimer

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Length;
using core::Result;
using core::Status;
using core::Triangle;

// Triangles read and sorted between two readings of the clock.
constexpr std::size_t kBatchTriangles = 1024;
constexpr std::size_t kReadTriangles = 128;  // read at once, then looked at

// A pipe is taken to be in order if its first triangles are out of order by at most this fraction
// (1/8) of the look-ahead.
constexpr std::size_t kGuessShare = 8;

std::size_t window_of(const OpenOptions& options) {
  return std::min(options.reorder_triangles, options.sort_bytes / sizeof(Triangle));
}

class MeshLayers : public LayerSource {
 public:
  MeshLayers(MeshInput mesh, const core::Settings& settings, const OpenOptions& options)
      : mesh_(std::move(mesh)),
        settings_(settings),
        options_(options),
        window_(window_of(options)),
        survey_(window_, adaptive_limits(settings), options.on_facet),
        guess_(std::max<std::size_t>(2, window_ / kGuessShare)) {}

  [[nodiscard]] Status look_ahead() {
    ahead_.reserve(window_ + kBatchTriangles);
    while (ahead_.size() < window_ && !ended_) {
      if (Status read = read_batch(); !read.ok()) return read;
      ahead_.insert(ahead_.end(), batch_.begin(), batch_.end());
      for (const Triangle& triangle : batch_) guess_.add(triangle);
    }
    if (ended_) return sort_all();
    if (Status plausible = check_so_far(); !plausible.ok()) return plausible;
    const bool in_order = survey_.in_order() && (options_.order_is_sure || guess_.in_order());
    // Adaptive heights are known at the surface's end, so is what a cut leaves.
    const bool whole_first = survey_.limits() || is_cut(settings_);
    if (mesh_.again || !options_.stream_pipes || !in_order || whole_first) return {};
    streaming_ = true;
    if (Status meant = check_tall(); !meant.ok()) return meant;
    shift_ = shift_to_bed(survey_.extent(), settings_);
    summarise();
    start_sweep(std::nullopt);
    return {};
  }

  [[nodiscard]] bool ready() const { return sweep_.has_value(); }

  [[nodiscard]] Result<PartSummary> read_rest() {
    const bool twice = mesh_.again && survey_.in_order();
    if (Status done = twice ? survey_rest() : sort_all(); !done.ok()) return done.error();
    return summary_;
  }

  [[nodiscard]] Result<std::optional<core::Slice>> next() override {
    const double start_s = thread_cpu_seconds();
    const double before_s = counters_.sort_cpu_s + counters_.read_cpu_s;
    Result<std::optional<core::Slice>> slice = sweep_->next();
    counters_.slice_cpu_s +=
        thread_cpu_seconds() - start_s - (counters_.sort_cpu_s + counters_.read_cpu_s - before_s);
    counters_.peak_triangles_held = sweep_->peak_triangles_held();
    ++slices_;
    return slice;
  }

  [[nodiscard]] const PartSummary& summary() const { return summary_; }
  [[nodiscard]] const PartCounters& counters() const { return counters_; }
  [[nodiscard]] PartPlacing placing() const { return {shift_, heights_}; }

 private:
  // The next triangles that a plane can cross.
  [[nodiscard]] Status read_batch() {
    const CpuTimer timer(counters_.read_cpu_s);
    batch_.clear();
    next_in_batch_ = 0;
    while (!ended_ && batch_.size() < kBatchTriangles) {
      const std::size_t wanted = std::min(kReadTriangles, kBatchTriangles - batch_.size());
      read_.clear();
      Status read = mesh_.triangles->next_some(wanted, read_);
      for (const Triangle& taken : read_) {
        if (surveyed_ && !survey_.extent().holds(taken)) {
          return refused(ErrorCode::kUnreadable, "the file was changed while it was being read");
        }
        const bool can_cut = surveyed_ ? can_be_cut(taken) : survey_.add(taken);
        if (can_cut && piece_.keeps(taken)) batch_.push_back(taken);
      }
      if (!read.ok()) return read;
      ended_ = read_.size() < wanted;
      if (Status whole = ended_ ? check_whole() : Status(); !whole.ok()) return whole;
    }
    return streaming_ ? check_tall() : Status();
  }

  // At the file's end. A file that was cut off between two triangles has an open surface.
  [[nodiscard]] Status check_whole() const {
    const std::string& doubt = mesh_.triangles->doubt();
    if (surveyed_ || doubt.empty() || survey_.closed()) return {};
    return refused(ErrorCode::kBadPart,
                   doubt + ", and the surface is open: it is cut short; copy or export it again");
  }

  // The look-ahead may already be too large.
  [[nodiscard]] Status check_so_far() {
    if (is_cut(settings_)) return {};
    return check_fit(shift_to_bed(survey_.extent(), settings_));
  }

  // The error names the stray corners, if there are any.
  [[nodiscard]] Status check_fit(const Shift& shift) {
    Status fits = check_on_bed(piece().extent(), shift, settings_, mesh_.name);
    if (fits.ok() || piece_.is_cut()) return fits;
    return Error{fits.error().code, fits.error().message + stray_text(survey_)};
  }

  // Checks that the height is plausible, as far as it is known.
  [[nodiscard]] Status check_tall() {
    if (options_.tall || !survey_.highest_cut()) return {};
    return streaming_ && !ended_ ? check_height_so_far(survey_, heights_, mesh_.name)
                                 : check_height(survey_, heights_, mesh_.name);
  }

  // Reads a file that is in order so far: to its end, or to the facet that breaks the order.
  [[nodiscard]] Status survey_rest() {
    ahead_ = {};
    while (!ended_ && survey_.in_order()) {
      if (Status read = read_batch(); !read.ok()) return read;
    }
    const bool in_order = survey_.in_order();
    if (in_order) {
      if (Status placed = place(); !placed.ok()) return placed;
    } else {
      survey_ = MeshSurvey(window_, adaptive_limits(settings_), options_.on_facet);
    }
    if (Status started = read_again(); !started.ok()) return started;
    if (!in_order) return sort_all();
    surveyed_ = true;
    start_sweep(summary_.layers);
    return check_and_restart();
  }

  [[nodiscard]] Status sort_all() {
    sorter_.emplace(MeshSorter::Options{options_.sort_bytes, ""});
    batch_.swap(ahead_);
    ahead_ = {};
    while (true) {
      const CpuTimer timer(counters_.sort_cpu_s);
      for (const Triangle& triangle : batch_) {
        if (Status added = sorter_->add(triangle); !added.ok()) return added;
      }
      if (ended_) break;
      const double read_s = counters_.read_cpu_s;
      if (Status read = read_batch(); !read.ok()) return read;
      counters_.sort_cpu_s -= counters_.read_cpu_s - read_s;
    }
    batch_ = {};
    if (Status placed = place(); !placed.ok()) return placed;
    const CpuTimer timer(counters_.sort_cpu_s);
    if (Status sorted = finish_sort(); !sorted.ok()) return sorted;
    start_sweep(summary_.layers);
    return check_and_restart();
  }

  [[nodiscard]] Status finish_sort() {
    if (sorted_) return {};
    sorted_ = true;
    Status sorted = sorter_->finish();
    counters_.spilled_bytes = sorter_->spilled_bytes();
    return sorted;
  }

  // Runs before anything moves; the heaters are on already if there was more than the look-ahead.
  [[nodiscard]] Status check_and_restart() {
    if (options_.plane_check == PlaneCheck::kNone || survey_.closed()) return {};
    const Result<OpenPlanes> open = check_planes(*sweep_);
    if (!open.ok()) return open.error();
    if (open.value().layers > 0) {
      const std::string first = std::to_string(open.value().first + 1);
      const std::string cause = std::to_string(open.value().layers) +
                                " layers have contours that can't be closed, the first is layer " +
                                first;
      if (options_.plane_check == PlaneCheck::kRefuse) {
        return refused(ErrorCode::kBadPart,
                       cause + "; repair the mesh, or say --on-bad-layer repair");
      }
      summary_.warnings.push_back(mesh_.name + ": " + cause + "; they are left out");
    }
    const Status started = sorter_ ? sorter_->rewind() : read_again();
    if (!started.ok()) return started;
    start_sweep(summary_.layers);
    return {};
  }

  // The triangles come once more, from the first. REQUIRES: mesh_.again
  [[nodiscard]] Status read_again() {
    const CpuTimer timer(counters_.read_cpu_s);
    ended_ = false;
    return mesh_.start_again();
  }

  void start_sweep(std::optional<core::LayerIndex> layers) {
    if (sorter_) {
      mesh_.triangles.reset();
    } else {
      window_held_ = ReorderWindow(std::move(ahead_));
    }
    batch_.clear();
    next_in_batch_ = 0;
    core::PlaneSweep::Options options{
        heights_, layers, settings_.simplify_tolerance, settings_.chain_gap_max, {}};
    if (const auto turned = streaming_ ? std::nullopt : survey_.turned()) {
      options.unsure = turned->placed ? shifted(turned->box, shift_) : core::Box();
    }
    sweep_.emplace(options, [this] { return sorter_ ? next_sorted() : next_in_window(); });
  }

  [[nodiscard]] Error refused(ErrorCode code, const std::string& cause) const {
    return {code, mesh_.name + ": " + cause};
  }

  // Reads the facets once more if there is a cut. REQUIRES: the mesh was read to its end.
  [[nodiscard]] Status cut_piece() {
    if (sorter_ && is_cut(settings_)) {
      const CpuTimer timer(counters_.sort_cpu_s);
      if (Status sorted = finish_sort(); !sorted.ok()) return sorted;
      Status cut = piece_.cut(settings_, survey_, mesh_.name, [this] { return sorter_->next(); });
      return cut.ok() ? sorter_->rewind() : cut;
    }
    const CpuTimer timer(counters_.read_cpu_s);
    return piece_.cut(settings_, survey_, mesh_.name, reopened(mesh_.again));
  }

  // REQUIRES: the mesh was read to its end.
  [[nodiscard]] Status place() {
    if (Status solid = check_not_flat(survey_, mesh_.name); !solid.ok()) return solid;
    if (Status cut = cut_piece(); !cut.ok()) return cut;
    if (Status solid = check_not_flat(piece(), mesh_.name); !solid.ok()) return solid;
    const MeshExtent& extent = piece().extent();
    summary_.height = Length::from_units(*piece().highest_cut() - extent.lowest_z);
    Result<core::LayerHeights> heights = part_heights(settings_, piece_.limits(survey_),
                                                      extent.lowest_z, summary_.height, mesh_.name);
    if (!heights.ok()) return heights.error();
    heights_ = std::move(heights).value();
    summarise_heights(heights_, summary_);
    Status sized = check_size(extent, summary_.height, heights_, settings_, mesh_.name);
    if (!sized.ok()) return sized;
    shift_ = shift_to_bed(extent, settings_);
    if (Status fits = check_fit(shift_); !fits.ok()) return fits;
    if (Status meant = check_tall(); !meant.ok()) return meant;
    summary_.seen_whole = !piece_.is_cut();
    summarise();
    return {};
  }

  [[nodiscard]] MeshSurvey& piece() { return piece_.survey(survey_); }

  void warn(const std::string& text) { summary_.warnings.push_back(mesh_.name + ": " + text); }

  void summarise() {
    summarise_file(*mesh_.triangles, survey_, mesh_.name, summary_);
    summary_.box = shifted(piece().extent().box, shift_);
    if (streaming_) {
      warn("sliced as it comes; its place on the bed is that of its first " +
           std::to_string(summary_.facets) + " facets");
      return;
    }
    if (const auto turned = survey_.turned()) {
      warn(turned_text(*turned));
    }
    const std::int64_t first_plane = piece().extent().lowest_z + heights_.doubled_plane(0) / 2;
    summary_.nothing_hangs =
        survey_.nothing_hangs_over(Length::from_units(first_plane - survey_.extent().lowest_z));
    warn_of_empty_layers(piece(), heights_, mesh_.name, summary_);
  }

  // Reads in batches, so that the clock is not read for each triangle.
  [[nodiscard]] Result<std::optional<Triangle>> next_sorted() {
    if (next_in_batch_ == batch_.size()) {
      const CpuTimer timer(counters_.sort_cpu_s);
      batch_.clear();
      next_in_batch_ = 0;
      while (batch_.size() < kBatchTriangles) {
        Result<std::optional<Triangle>> triangle = sorter_->next();
        if (!triangle.ok()) return triangle.error();
        if (!triangle.value()) break;
        if (piece_.keeps(*triangle.value())) batch_.push_back(*triangle.value());
      }
      if (batch_.empty()) return std::optional<Triangle>();
    }
    return std::optional<Triangle>(shifted(batch_[next_in_batch_++], shift_));
  }

  [[nodiscard]] Result<std::optional<Triangle>> next_in_window() {
    while (window_held_.size() <= window_) {
      if (next_in_batch_ == batch_.size()) {
        if (ended_) break;
        if (Status read = read_batch(); !read.ok()) return read.error();
        continue;
      }
      const Triangle& triangle = batch_[next_in_batch_++];
      if (streaming_) {
        if (Status fits = check_arrival(triangle); !fits.ok()) return fits.error();
      }
      window_held_.push(triangle);
    }
    if (window_held_.empty()) return std::optional<Triangle>();
    return std::optional<Triangle>(shifted(window_held_.pop(), shift_));
  }

  // For a pipe that is sliced as it arrives: the facet must be on the bed and not too late.
  [[nodiscard]] Status check_arrival(const Triangle& triangle) {
    MeshExtent extent;
    extent.add(triangle);
    extent.lowest_z = -shift_.z;
    const std::string name =
        mesh_.name + ": near facet " + std::to_string(mesh_.triangles->facets());
    if (Status fits = check_on_bed(extent, shift_, settings_, name); !fits.ok()) return fits;
    const std::int64_t low = triangle.lowest_z() + shift_.z;
    const core::LayerIndex first_cut = heights_.count(Length::from_units(low));
    const core::LayerIndex cut_below =
        heights_.count(Length::from_units(triangle.highest_z() + shift_.z));
    if (low >= 0 && (first_cut >= slices_ || first_cut == cut_below)) return {};
    return Error{ErrorCode::kBadPart,
                 name + ": it reaches down to " + mm_text(low) + " mm, below layer " +
                     std::to_string(slices_ + 1) +
                     " that has been reached: the facets do not come in order of height; say "
                     "--sorted no"};
  }

  MeshInput mesh_;
  core::Settings settings_;
  core::LayerHeights heights_ = layer_heights(settings_);
  OpenOptions options_;
  std::size_t window_;
  MeshSurvey survey_;
  MeshPiece piece_;
  OrderGauge guess_;  // of the look-ahead
  PartSummary summary_;
  PartCounters counters_;
  Shift shift_;
  std::vector<Triangle> ahead_;  // the look-ahead, until it is decided how the mesh is read
  std::vector<Triangle> read_;
  std::vector<Triangle> batch_;
  std::size_t next_in_batch_ = 0;
  bool ended_ = false, surveyed_ = false;  // all has been read; it is read for the second time
  bool streaming_ = false;                 // it is sliced as it arrives
  bool sorted_ = false;                    // the sorter has all, and is finished
  std::optional<MeshSorter> sorter_;
  ReorderWindow window_held_;
  std::optional<core::PlaneSweep> sweep_;
  core::LayerIndex slices_ = 0;  // given so far
};

}  // namespace

Result<OpenedPart> open_mesh(MeshInput mesh, const core::Settings& settings,
                             const OpenOptions& options) {
  auto layers = std::make_unique<MeshLayers>(std::move(mesh), settings, options);
  if (Status looked = layers->look_ahead(); !looked.ok()) return looked.error();
  OpenedPart part;
  part.summary = layers->summary();
  MeshLayers* source = layers.get();
  if (!source->ready()) part.read_rest = [source] { return source->read_rest(); };
  part.counters = [source] { return source->counters(); };
  part.placing = [source] { return source->placing(); };
  part.layers = std::move(layers);
  return part;
}

}  // namespace host
