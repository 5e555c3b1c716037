// What slicers tell in comments: where layers start, and how long the print takes.
//
//     ;LAYER_CHANGE      PrusaSlicer, SuperSlicer, OrcaSlicer        ; CHANGE_LAYER   Bambu Studio
//     ;LAYER:12          Cura                                        ; layer 12, …    Simplify3D
//     ; estimated printing time (normal mode) = 1d 2h 3m 4s          ;TIME:3723       Cura
#pragma once

#include <optional>
#include <string_view>

namespace host {

[[nodiscard]] bool starts_layer(std::string_view comment);

// In seconds.
[[nodiscard]] std::optional<double> printing_time_in(std::string_view comment);

// "1d 2h 3m 4s", "62 minutes", "3723" (seconds).
[[nodiscard]] std::optional<double> seconds_in(std::string_view text);

// What M73 tells to be left, in seconds: "M73 P0 R62".
[[nodiscard]] std::optional<double> time_left_in(std::string_view line);

}  // namespace host
