#include "host/pipeline/layer_pace.h"

#include <fmt/format.h>

#include <utility>

#include "host/system/limits.h"  // kUnderrun_s

namespace host {
namespace {

// Computing may take a few milliseconds only.
std::string seconds_text(double seconds) {
  return seconds < 0.1 ? fmt::format("{:.1f} ms", seconds * 1e3) : fmt::format("{:.2f} s", seconds);
}

}  // namespace

void LayerPace::add(core::LayerIndex layer, double computing_s, double printed_s) {
  waiting_s_ += computing_s;
  if (printed_s <= printed_s_) return;
  const double before_s = std::exchange(printed_s_, printed_s);
  const PacedLayer paced{layer, std::exchange(waiting_s_, 0), printed_s - before_s};
  if (before_s == 0) {
    before_first_layer_s_ = paced.computing_s;
    return;
  }
  if (!slowest_ || paced.computing_s > slowest_->computing_s) slowest_ = paced;
  if (paced.behind_s() <= kUnderrun_s) return;
  ++behind_;
  if (!furthest_ || paced.behind_s() > furthest_->behind_s()) furthest_ = paced;
}

std::string pace_text(const LayerPace& pace) {
  if (!pace.slowest()) return "";
  if (pace.behind() == 0) {
    return fmt::format(
        "the slowest layer ({}) takes this computer {}, and {:.1f} s to print: "
        "it keeps up",
        pace.slowest()->layer + 1, seconds_text(pace.slowest()->computing_s),
        pace.slowest()->printing_s);
  }
  const PacedLayer& worst = *pace.furthest_behind();
  return fmt::format(
      "warning: {} take{} this computer longer than the printer, at worst layer {}: {}, and "
      "{:.1f} s to print; the nozzle may have to wait there, off the part",
      pace.behind() == 1 ? "1 layer" : fmt::format("{} layers", pace.behind()),
      pace.behind() == 1 ? "s" : "", worst.layer + 1, seconds_text(worst.computing_s),
      worst.printing_s);
}

}  // namespace host
