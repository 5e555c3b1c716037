#include "host/pipeline/layer_times.h"

#include <algorithm>
#include <cmath>

namespace host {
namespace {

constexpr double kFirstBinS = 1e-6;
constexpr double kBinRatio = 1.05;

}  // namespace

void LayerTimes::add(core::LayerIndex layer, double seconds) {
  const double bin = std::log(std::max(seconds, kFirstBinS) / kFirstBinS) / std::log(kBinRatio);
  ++counts_[std::min(static_cast<std::size_t>(bin), kBins - 1)];
  ++layers_;
  if (seconds <= worst_s_) return;
  worst_s_ = seconds;
  worst_layer_ = layer;
}

double LayerTimes::median_ms() const {
  std::int64_t below = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    below += counts_[bin];
    if (2 * below < layers_ || below == 0) continue;
    return kFirstBinS * std::pow(kBinRatio, static_cast<double>(bin) + 0.5) * 1e3;
  }
  return 0;
}

}  // namespace host
