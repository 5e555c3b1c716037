// A window of layers in the middle of a prism.
#pragma once

#include <doctest/doctest.h>

#include <cstdint>

#include "core/booleans/boolean.h"
#include "core/sections/layer_window.h"
#include "core/settings.h"

namespace test {

inline core::Ring square(std::int32_t low, std::int32_t high) {
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}

// Layers of a prism; the window stands at the seventh.
inline core::LayerWindow window_in_prism(const core::Settings& settings) {
  core::LayerWindow window(settings);
  for (int n = 0; n < 12; ++n) {
    core::SplitLayer layer;
    layer.slice.index = n;
    layer.slice.bottom = core::Length::from_mm(0.2) * n;
    layer.slice.height = core::Length::from_mm(0.2);
    layer.slice.region = core::Region::from_clean_rings({square(0, 100'000)});
    layer.loose = core::Region::from_clean_rings({square(10'000, 90'000)});
    layer.solid = core::subtract(layer.slice.region, layer.loose);
    window.push(layer);
    while (window.next()) {
      if (window.layer().slice.index == 6) return window;
    }
  }
  FAIL("the seventh layer never came");
  return window;
}

}  // namespace test
