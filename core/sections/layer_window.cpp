#include "core/sections/layer_window.h"

#include <utility>

#include "core/check.h"                // RIND_CHECK
#include "core/limits.h"               // kWindowLayersMax
#include "core/offsets/wall_depths.h"  // ball_depth

namespace core {
namespace {

// Doubled, because a mid-plane can lie between two units.
Length doubled_middle(const Slice& slice) { return slice.bottom * 2 + slice.height; }

Length doubled_gap(const Slice& from, const Slice& to) {
  if (to.index == from.index) return {};
  return to.index > from.index ? to.bottom * 2 - doubled_middle(from)
                               : doubled_middle(from) - to.top() * 2;
}

}  // namespace

LayerWindow::LayerWindow(const Settings& settings)
    : settings_(settings),
      cylinder_(settings.wall_shape == WallShape::kCylinder || settings.style == BuildStyle::kFast),
      layers_(kWindowLayersMax) {}

bool LayerWindow::within_reach(const Slice& from, const Slice& to) const {
  if (cylinder_) return std::abs(to.index - from.index) <= wall_layers(settings_);
  return doubled_gap(from, to) < settings_.wall_thickness * 2;
}

bool LayerWindow::reaches_below(const Slice& slice) const {
  return cylinder_ ? slice.index < wall_layers(settings_)
                   : doubled_middle(slice) < settings_.wall_thickness * 2;
}

bool LayerWindow::all_above_known(const Slice& slice) const {
  const Slice& newest = layers_[layers_.size() - 1].slice;
  return cylinder_ ? newest.index - slice.index >= wall_layers(settings_)
                   : newest.top() * 2 - doubled_middle(slice) >= settings_.wall_thickness * 2;
}

void LayerWindow::push(SplitLayer layer) {
  RIND_CHECK(!finished_);
  // What not even the next layer can see.
  while (next_ > 0 && place_ > 0 && next_ < layers_.size() &&
         !within_reach(layers_[next_].slice, layers_[0].slice)) {
    (void)layers_.pop();
    --place_;
    --next_;
  }
  layers_.push(std::move(layer));
}

bool LayerWindow::next() {
  if (next_ == layers_.size()) return false;
  if (!finished_ && !all_above_known(layers_[next_].slice)) return false;
  place_ = next_++;
  return true;
}

std::vector<LayerWindow::Neighbour> LayerWindow::neighbours() const {
  const Slice& slice = layer().slice;
  std::vector<Neighbour> found;
  const auto add = [&](std::size_t place) {
    const SplitLayer& other = layers_[place];
    if (!within_reach(slice, other.slice)) return false;
    const Length gap = doubled_gap(slice, other.slice);
    found.push_back(
        {&other, cylinder_ ? settings_.wall_thickness : ball_depth(settings_.wall_thickness, gap),
         Length::from_units(gap.units() / 2)});
    return true;
  };
  add(place_);
  bool up = true, down = true;
  for (std::size_t i = 1; up || down; ++i) {
    up = up && place_ + i < layers_.size() && add(place_ + i);
    down = down && i <= place_ && add(place_ - i);
  }
  return found;
}

bool LayerWindow::reaches_out() const {
  const Slice& slice = layer().slice;
  return reaches_below(slice) || !all_above_known(slice);
}

}  // namespace core
