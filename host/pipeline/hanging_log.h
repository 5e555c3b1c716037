// What of a part hangs in the air (core/roads/hanging_places.h): how much, and where first.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/roads/hanging_places.h"  // HangingKind, HangingPlaces
#include "core/units.h"                 // LayerIndex, Length
#include "host/system/limits.h"         // kHangingTold

namespace host {

// What is done about an island that begins in the air.
enum class OnFloating {
  kWarn,
  kStop,  // the print ends before that layer
};

// The word of the option. An unknown word is `warn`.
[[nodiscard]] std::string floating_word(OnFloating action);
[[nodiscard]] OnFloating floating_of(const std::string& word);

struct HangingSpot {
  core::LayerIndex layer = 0;  // counted from 0
  core::Length height;         // of the layer's bottom
  core::HangingPlace place;
};

// "an island of 25.0 mm² begins in the air at (160, 150) mm on the bed, layer 51, 10 mm high"
[[nodiscard]] std::string hanging_text(const HangingSpot& spot);

class HangingLog {
 public:
  struct Kind {
    std::int64_t count = 0;
    std::int64_t layers = 0;         // that have any
    std::vector<HangingSpot> first;  // kHangingTold at most
    HangingSpot largest;
  };

  // REQUIRES: layers from the bed up.
  void add(core::LayerIndex layer, core::Length bottom, const core::HangingPlaces& places);

  [[nodiscard]] const Kind& of(core::HangingKind kind) const {
    return kinds_[static_cast<std::size_t>(kind)];
  }

  // One line for each kind that there is: how many, the first few, the largest.
  [[nodiscard]] std::vector<std::string> summary() const;

 private:
  std::array<Kind, core::kHangingKinds> kinds_;
};

}  // namespace host
