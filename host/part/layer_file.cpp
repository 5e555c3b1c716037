#include "host/part/layer_file.h"

#include <deque>
#include <optional>
#include <utility>

#include "host/part/bed_placing.h"      // shift_to_bed, check_on_bed
#include "host/part/cut_plane.h"        // is_cut
#include "host/part/layer_rules.h"      // check_layer_height
#include "host/part/moved_slice.h"      // moved
#include "host/part/part_transform.h"   // PartTransform
#include "host/part/transform_words.h"  // read_cut
#include "host/system/stage_clock.h"    // CpuTimer

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Length;
using core::Result;
using core::Slice;
using core::Status;

void add(const Slice& slice, MeshExtent& extent) {
  extent.box.add(slice.region.box());
  for (const core::Ring& ring : slice.region.rings()) {
    for (const core::Point point : ring) extent.reach.add(point);
  }
  extent.lowest_z = std::min(extent.lowest_z, slice.bottom.units());
  extent.highest_z = std::max(extent.highest_z, slice.top().units());
}

// Keeps the layers of one piece of a part that is cut in two. The cut lies where a layer begins.
class LayerCut {
 public:
  // REQUIRES: check_part_transform() is fine, and not both pieces are asked for
  explicit LayerCut(const core::Settings& settings) : words_(read_cut(settings.cut).value()) {}

  [[nodiscard]] bool none() const { return !words_; }

  // Takes the layers in order. Whether the layer belongs to the piece; its index is made that of
  // the piece.
  [[nodiscard]] bool keeps(Slice& slice) {
    if (!words_) return true;
    if (!lowest_) lowest_ = slice.bottom;
    const Length plane = *lowest_ + Length::from_mm(words_->height_mm);
    const bool lower = slice.bottom + slice.top() < plane * 2;
    if (lower) moved_to_ = slice.top();
    (lower ? below_ : above_) = true;
    if (lower == (words_->piece == CutPiece::kLower)) {
      slice.index -= left_out_;
      return true;
    }
    ++left_out_;
    return false;
  }

  // No further layer belongs to the piece.
  [[nodiscard]] bool over() const { return words_ && words_->piece == CutPiece::kLower && above_; }

  // All of the lower piece has been seen.
  [[nodiscard]] bool over_below() const { return above_; }

  // Of layers that were all taken: one piece holds nothing.
  [[nodiscard]] bool misses() const { return words_ && !(below_ && above_); }

  // Tells where the cut lies; nullopt if it is where it was asked for.
  [[nodiscard]] std::optional<std::string> warning() const {
    if (!words_ || !moved_to_) return std::nullopt;
    const Length cut = *moved_to_ - *lowest_;
    if (cut == Length::from_mm(words_->height_mm)) return std::nullopt;
    return "cut at " + mm_text(cut.units()) + " mm, where a layer begins";
  }

 private:
  std::optional<CutWords> words_;
  std::optional<Length> lowest_;    // of the part
  std::optional<Length> moved_to_;  // the top of the lower piece so far
  core::LayerIndex left_out_ = 0;
  bool below_ = false, above_ = false;  // layers of the pieces have been seen
};

class PlacedLayers : public LayerSource {
 public:
  PlacedLayers(LayerFileInput file, const core::Settings& settings)
      : file_(std::move(file)), settings_(settings) {}

  // Of a pipe: its first layer.
  [[nodiscard]] Status look_ahead() {
    summary_.format = file_.layers->format();
    if (file_.again) return {};
    if (cut_.none()) summary_.layers = file_.layers->layers_promised();
    MeshExtent extent;
    while (extent.box.empty()) {
      Result<std::optional<Slice>> slice = read();
      if (!slice.ok()) return slice.error();
      if (!slice.value() || ahead_.size() == kEmptyLayersMax) return nothing_to_print();
      add(*slice.value(), extent);
      ahead_.push_back(*std::move(slice).value());
    }
    // Of the whole part.
    const std::optional<core::Box> promised =
        cut_.none() ? file_.layers->box_promised() : std::nullopt;
    if (promised) {
      const Result<core::Box> larger = transform_.of(*promised);
      if (!larger.ok()) return refused(larger.error());
      extent.box = larger.value();
    }
    if (Status placed = place(extent); !placed.ok()) return placed;
    take_warnings();
    if (promised) return {};
    summary_.warnings.push_back(file_.name +
                                ": sliced as it comes; its place on the bed is that of its first "
                                "layer");
    summary_.box = {};
    return {};
  }

  // Of a file: everything, once.
  [[nodiscard]] Result<PartSummary> read_rest() {
    MeshExtent extent;
    while (true) {
      Result<std::optional<Slice>> slice = read();
      if (!slice.ok()) return slice.error();
      if (!slice.value()) break;
      if (Status fits = check_layer_height(file_.name, *slice.value(), settings_); !fits.ok()) {
        return fits.error();
      }
      // Empty layers on top don't count.
      extent.lowest_z = std::min(extent.lowest_z, slice.value()->bottom.units());
      if (slice.value()->region.empty()) continue;
      add(*slice.value(), extent);
      summary_.layers = slice.value()->index + 1;
    }
    if (cut_.misses()) return cut_misses();
    if (extent.box.empty()) return nothing_to_print();
    if (Status placed = place(extent); !placed.ok()) return placed.error();
    summary_.height = Length::from_units(extent.highest_z - extent.lowest_z);
    take_warnings();
    Result<std::unique_ptr<LayerReader>> again = file_.again();
    if (!again.ok()) return again.error();
    file_.layers = std::move(again).value();
    cut_ = LayerCut(settings_);
    return summary_;
  }

  [[nodiscard]] Result<std::optional<Slice>> next() override {
    if (ahead_.empty()) {
      if (Status read = read_on(); !read.ok()) return read.error();
    }
    if (ahead_.empty()) return std::optional<Slice>();
    Slice slice = std::move(ahead_.front());
    ahead_.pop_front();
    return placed(std::move(slice));
  }

  [[nodiscard]] const PartSummary& summary() const { return summary_; }
  [[nodiscard]] const PartCounters& counters() const { return counters_; }

 private:
  [[nodiscard]] Result<std::optional<Slice>> read() {
    const CpuTimer timer(counters_.read_cpu_s);
    Result<std::optional<Slice>> slice = file_.layers->next();
    while (slice.ok() && slice.value() && !cut_.keeps(*slice.value())) {
      if (cut_.over()) return std::optional<Slice>();
      slice = file_.layers->next();
    }
    if (!slice.ok() || !slice.value() || transform_.none()) return slice;
    Result<core::Region> larger = transform_.of(slice.value()->region);
    if (!larger.ok()) return refused(larger.error());
    slice.value()->region = std::move(larger).value();
    return slice;
  }

  [[nodiscard]] Error refused(const Error& error) const {
    return {error.code, file_.name + ": " + error.message};
  }

  // Reads the next layer. Empty ones are held back until one with contours follows.
  [[nodiscard]] Status read_on() {
    while (true) {
      Result<std::optional<Slice>> slice = read();
      if (!slice.ok()) return slice.error();
      if (!slice.value()) {
        ahead_.clear();
        return {};
      }
      ahead_.push_back(*std::move(slice).value());
      if (!ahead_.back().region.empty() || ahead_.size() == kEmptyLayersMax) return {};
    }
  }

  void take_warnings() {
    summary_.warnings = file_.layers->warnings();
    // Of a lower piece from a pipe, it is not known yet.
    const auto moved = file_.again || cut_.over_below() ? cut_.warning() : std::nullopt;
    if (moved) summary_.warnings.push_back(file_.name + ": " + *moved);
    if (!core::has_unequal_layers(settings_)) return;
    summary_.warnings.push_back(file_.name +
                                ": its layers have heights of their own: adaptive_layer_height "
                                "and height_range change nothing");
  }

  [[nodiscard]] Error cut_misses() const {
    return {ErrorCode::kBadSetting, file_.name + ": cut = " + settings_.cut +
                                        ": all layers are on one side of it; give a height within "
                                        "the part"};
  }

  [[nodiscard]] Error nothing_to_print() const {
    return {ErrorCode::kBadPart, file_.name +
                                     ": no layer has a closed contour, so there is nothing to "
                                     "print; export the part's contours"};
  }

  [[nodiscard]] Status place(const MeshExtent& extent) {
    shift_ = shift_to_bed(extent, settings_);
    if (Status fits = check_on_bed(extent, shift_, settings_, file_.name); !fits.ok()) return fits;
    summary_.box = shifted(extent.box, shift_);
    return {};
  }

  [[nodiscard]] Result<std::optional<Slice>> placed(Slice slice) const {
    MeshExtent extent;
    add(slice, extent);
    const std::string where = file_.name + ": layer " + std::to_string(slice.index + 1);
    if (!extent.box.empty()) {
      if (Status fits = check_on_bed(extent, shift_, settings_, where); !fits.ok()) {
        return fits.error();
      }
      slice.region = moved(slice.region, shift_);
    }
    slice.bottom += Length::from_units(shift_.z);
    return std::optional<Slice>(std::move(slice));
  }

  LayerFileInput file_;
  core::Settings settings_;
  PartTransform transform_{settings_};
  LayerCut cut_{settings_};
  PartSummary summary_;
  PartCounters counters_;
  Shift shift_;
  std::deque<Slice> ahead_;  // until they are asked for
};

}  // namespace

Result<OpenedPart> open_layer_file(LayerFileInput file, const core::Settings& settings) {
  const PartTransform by(settings);
  if (!by.keeps_heights() || by.units_told()) {
    return Error{ErrorCode::kBadSetting,
                 file.name +
                     ": the heights and the unit of a file of layers are fixed: it can be mirrored "
                     "along x and y, turned about z and scaled sideways (--scale 2,2,1), but "
                     "shrinkage_z, part_units and others would change them; or print the mesh"};
  }
  if (Status one = check_one_piece(settings, file.name); !one.ok()) return one.error();
  const bool twice = file.again != nullptr;
  auto layers = std::make_unique<PlacedLayers>(std::move(file), settings);
  if (Status looked = layers->look_ahead(); !looked.ok()) return looked.error();
  OpenedPart part;
  part.summary = layers->summary();
  PlacedLayers* source = layers.get();
  if (twice) part.read_rest = [source] { return source->read_rest(); };
  part.counters = [source] { return source->counters(); };
  part.layers = std::move(layers);
  return part;
}

}  // namespace host
