// Reads how a part is scaled, turned and cut, as people write it.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/result.h"  // Result

namespace host {

inline constexpr double kScaleMin = 1e-4;
inline constexpr double kScaleMax = 1e4;

struct ScaleWords {
  std::array<double, 3> factors = {1, 1, 1};  // along x, y, z
  std::optional<double> longest_mm;           // "to 100 mm": instead of the factors
};

// "2", "150%", "1,1,2", "to 100", "to 100mm".
[[nodiscard]] core::Result<ScaleWords> read_scale(std::string_view text);

inline constexpr double kCutMax_mm = 1e9;

enum class CutPiece { kBoth, kLower, kUpper };

struct CutWords {
  double height_mm = 0;  // above the part's lowest point; > 0
  CutPiece piece = CutPiece::kBoth;
};

// "20", "20 mm", "20 lower", "20 upper"; nullopt for "off" and for no text.
[[nodiscard]] core::Result<std::optional<CutWords>> read_cut(std::string_view text);

// "90,0,45": degrees about x, y, z; "45": about z.
[[nodiscard]] core::Result<std::array<double, 3>> read_rotation(std::string_view text);

}  // namespace host
