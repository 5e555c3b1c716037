#include "core/sections/layer_window.h"

#include <utility>

#include "core/check.h"   // RIND_CHECK
#include "core/limits.h"  // kWindowLayersMax

namespace core {

LayerWindow::LayerWindow(const Settings& settings)
    : settings_(settings), reach_(settings), layers_(kWindowLayersMax) {}

bool LayerWindow::all_above_known(const Slice& slice) const {
  return reach_.ends_within(layers_[layers_.size() - 1].slice, slice);
}

void LayerWindow::push(SplitLayer layer) {
  RIND_CHECK(!finished_);
  // What not even the next layer can see.
  while (next_ > 0 && current_ > 0 && next_ < layers_.size() &&
         !reach_.includes(layers_[next_].slice, layers_[0].slice)) {
    (void)layers_.pop();
    --current_;
    --next_;
  }
  layers_.push(std::move(layer));
}

bool LayerWindow::next() {
  if (next_ == layers_.size()) return false;
  if (!finished_ && !all_above_known(layers_[next_].slice)) return false;
  current_ = next_++;
  return true;
}

std::vector<LayerWindow::Neighbour> LayerWindow::neighbours() const {
  const Slice& slice = layer().slice;
  std::vector<Neighbour> found;
  visit_outwards(layers_.size(), current_, [&](std::size_t number) {
    const SplitLayer& other = layers_[number];
    if (!reach_.includes(slice, other.slice)) return false;
    found.push_back({&other, reach_.depth(slice, other.slice)});
    return true;
  });
  return found;
}

bool LayerWindow::reaches_out() const {
  const Slice& slice = layer().slice;
  return reach_.includes_bed(slice) || !all_above_known(slice);
}

}  // namespace core
