// Whether this computer keeps up with the printer: what each layer takes to compute, beside what it
// takes to print. In constant memory.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/units.h"  // LayerIndex

namespace host {

struct PacedLayer {
  core::LayerIndex layer = 0;  // counted from 0
  double computing_s = 0;      // processor time of all its stages
  double printing_s = 0;       // estimated

  [[nodiscard]] double behind_s() const { return computing_s - printing_s; }
};

class LayerPace {
 public:
  // `printed_s`: what all layers take to print, up to this one.
  //
  // What is computed before a layer that is printed, such as layers that only fill the window,
  // counts as that layer's. The first printed layer is computed while the printer heats, so it is
  // not compared.
  void add(core::LayerIndex layer, double computing_s, double printed_s);

  // Until the first layer could be printed.
  [[nodiscard]] double before_first_layer_s() const { return before_first_layer_s_; }
  // The layer that took longest to compute; none of one layer.
  [[nodiscard]] const std::optional<PacedLayer>& slowest() const { return slowest_; }

  // Layers that took longer to compute than to print, by more than kUnderrun_s: the nozzle may have
  // to leave the part there, where the commands in the queue don't bridge it.
  [[nodiscard]] std::int64_t behind() const { return behind_; }
  [[nodiscard]] const std::optional<PacedLayer>& furthest_behind() const { return furthest_; }

 private:
  double waiting_s_ = 0;  // computed, nothing printed since
  double printed_s_ = 0;
  double before_first_layer_s_ = 0;
  std::optional<PacedLayer> slowest_;
  std::int64_t behind_ = 0;
  std::optional<PacedLayer> furthest_;
};

// "the slowest layer (12) takes this computer 0.31 s, and 45.0 s to print: it keeps up"; empty
// where there is nothing to compare.
[[nodiscard]] std::string pace_text(const LayerPace& pace);

}  // namespace host
