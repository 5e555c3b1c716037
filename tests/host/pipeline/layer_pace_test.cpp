#include "host/pipeline/layer_pace.h"

#include <doctest/doctest.h>

#include <string>

#include "host/system/limits.h"

namespace {

// Given each layer's own printing time.
struct Pace : host::LayerPace {
  void add(core::LayerIndex layer, double computing_s, double printing_s) {
    printed_s += printing_s;
    host::LayerPace::add(layer, computing_s, printed_s);
  }
  double printed_s = 0;
};

}  // namespace

TEST_CASE("nothing, or one layer: nothing to compare") {
  Pace pace;
  CHECK_EQ(host::pace_text(pace), "");
  pace.add(0, 1.5, 0);
  pace.add(0, 2, 30);
  CHECK_EQ(pace.before_first_layer_s(), 3.5);
  CHECK_EQ(host::pace_text(pace), "");
}

TEST_CASE("the slowest layer is told, and that it keeps up") {
  Pace pace;
  for (int layer = 0; layer < 20; ++layer) pace.add(layer, layer == 11 ? 0.31 : 0.05, 45);
  CHECK_EQ(host::pace_text(pace),
           "the slowest layer (12) takes this computer 0.31 s, and 45.0 s to print: it keeps up");
}

TEST_CASE("layers that fill the window, or print nothing, are counted with the next one") {
  Pace pace;
  pace.add(0, 1, 10);
  for (int i = 0; i < 4; ++i) pace.add(1, 2, 0);
  pace.add(5, 1, 10);
  REQUIRE(pace.slowest());
  CHECK_EQ(pace.slowest()->layer, 5);
  CHECK_EQ(pace.slowest()->computing_s, 9);
  CHECK_EQ(pace.behind(), 0);
}

TEST_CASE("layers that fall behind are counted, the worst is told") {
  Pace pace;
  pace.add(0, 100, 1);  // while it heats
  pace.add(1, 5, 5 - host::kUnderrun_s * 0.9);
  CHECK_EQ(pace.behind(), 0);
  pace.add(2, 5, 4);
  CHECK(host::pace_text(pace).starts_with(
      "warning: 1 layer takes this computer longer than the printer"));
  pace.add(3, 8.25, 3);
  pace.add(4, 20, 19);
  CHECK_EQ(pace.behind(), 3);
  CHECK_EQ(
      host::pace_text(pace),
      "warning: 3 layers take this computer longer than the printer, at worst layer 4: 8.25 s, "
      "and 3.0 s to print; the nozzle may have to wait there, off the part");
}
