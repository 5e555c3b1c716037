#include "core/raft_heights.h"

#include <doctest/doctest.h>

using namespace core;

namespace {

Settings on_raft(int layers) {
  Settings settings;
  settings.layer_height = Length::from_mm(0.2);
  settings.first_layer_height = Length::from_mm(0.35);
  settings.raft_contact_distance = Length::from_mm(0.12);
  settings.raft_layers = layers;
  return settings;
}

}  // namespace

TEST_CASE("layers of the raft lie one on the other, the part a gap above them") {
  for (const int layers : {1, 2, 3, 7}) {
    CAPTURE(layers);
    const Settings settings = on_raft(layers);
    Length height;
    for (int layer = 0; layer < layers; ++layer) {
      CHECK_EQ(raft_layer_bottom(settings, layer), height);
      height += raft_layer_height(settings, layer);
    }
    CHECK_EQ(height.mm(), doctest::Approx(0.35 + 0.2 * (layers - 1)));
    CHECK_EQ(raft_lift(settings), height + settings.raft_contact_distance);
    CHECK_FALSE(is_above_raft(settings, layers - 1));
    CHECK(is_above_raft(settings, layers));
    CHECK_FALSE(is_above_raft(settings, layers + 1));
  }
  Settings settings = on_raft(2);
  settings.first_layer_height = Length();
  CHECK_EQ(raft_lift(settings).mm(), doctest::Approx(0.2 + 0.2 + 0.12));
}

TEST_CASE("without a raft nothing is lifted, and the first layer is the part's") {
  Settings settings = on_raft(0);
  settings.axis_z = Length::from_mm(100);
  settings.brim_width = Length::from_mm(5);
  CHECK_EQ(raft_lift(settings), Length());
  CHECK_FALSE(is_above_raft(settings, 0));
  const Settings above = settings_above_raft(settings);
  CHECK_EQ(above.first_layer_height, settings.first_layer_height);
  CHECK_EQ(above.axis_z, settings.axis_z);
  CHECK_EQ(above.brim_width, settings.brim_width);
  CHECK_EQ(above.skirt_loops, settings.skirt_loops);
}

TEST_CASE("above a raft no layer is a first one, and the axis ends lower") {
  Settings settings = on_raft(3);
  settings.axis_z = Length::from_mm(100);
  settings.first_layer_width = Length::from_mm(0.6);
  settings.first_layer_flow = 1.2;
  settings.elephant_foot_compensation = Length::from_mm(0.2);
  settings.brim_width = Length::from_mm(5);
  settings.skirt_length_min = Length::from_mm(500);
  const Settings above = settings_above_raft(settings);
  CHECK_EQ(above.first_layer_height, Length());
  CHECK_EQ(above.first_layer_width, Length());
  CHECK_EQ(above.first_layer_flow, 1);
  CHECK_EQ(above.elephant_foot_compensation, Length());
  CHECK_EQ(above.brim_width, Length());
  CHECK_EQ(above.skirt_loops, 0);
  CHECK_EQ(above.skirt_length_min, Length());
  CHECK_EQ(above.axis_z.mm(), doctest::Approx(100 - 0.35 - 0.4 - 0.12));
}
