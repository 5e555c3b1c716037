// The note and event of a layer that takes long to compute.
#pragma once

#include "host/pipeline/layer_watch.h"  // SlowLayer
#include "host/printing/progress.h"     // Reporter

namespace host {

inline void tell_slow_layer(const SlowLayer& slow, Reporter& reporter) {
  reporter.note("slow_layer", slow_layer_text(slow),
                {{"layer", slow.layer + 1},
                 {"height_mm", slow.height.mm()},
                 {"edges", slow.size.edges},
                 {"islands", slow.size.islands},
                 {"seconds", slow.seconds}});
}

}  // namespace host
