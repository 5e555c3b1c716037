// The tests, one in each file, and what they have in common. Each takes what was asked for and the
// settings; plan_calibration() checks afterwards that bed and axis hold the body.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"                   // Result
#include "core/units.h"                    // Length
#include "host/calibration/calibration.h"  // Calibration
#include "host/pipeline/print_settings.h"  // PrintSettings

namespace host {

[[nodiscard]] core::Result<Calibration> first_layer_squares(const PrintSettings& settings);
[[nodiscard]] core::Result<Calibration> temperature_tower(const CalibrationRequest& request,
                                                          const PrintSettings& settings);
[[nodiscard]] core::Result<Calibration> retraction_towers(const CalibrationRequest& request,
                                                          const PrintSettings& settings);
[[nodiscard]] core::Result<Calibration> flow_box(const PrintSettings& settings);
[[nodiscard]] core::Result<Calibration> pressure_advance_frame(const CalibrationRequest& request,
                                                               const PrintSettings& settings);
[[nodiscard]] core::Result<Calibration> max_flow_loop(const CalibrationRequest& request,
                                                      const PrintSettings& settings);

// The nearest height of whole layers, at least one. All that lies level ends there: no plane cuts a
// body exactly where it ends.
[[nodiscard]] double in_layers(const PrintSettings& settings, double mm);

// Blocks of whole layers, one for each value, about as high as wanted, on a base of about a
// millimetre.
[[nodiscard]] std::vector<CalibrationBlock> blocks_of(const PrintSettings& settings,
                                                      const std::vector<double>& values,
                                                      double block_mm);

// The setting has its block's value in each block; the settings' own actions at heights stay.
void vary(std::string_view key, std::string_view unit, std::vector<CalibrationBlock> blocks,
          const PrintSettings& settings, Calibration& calibration);

// A column through all blocks, from the base up, with a groove where a block begins.
void add_notched_column(const PrintSettings& settings, const std::vector<CalibrationBlock>& blocks,
                        Span x, Span y, TestSolid& solid);

// Each block's value on the face of such a column, in its middle. `at`: x and y.
void add_labels(const PrintSettings& settings, const std::vector<CalibrationBlock>& blocks,
                Place at, LabelSide side, const LabelForm& form, TestSolid& solid);

// Digits of at least two roads, for blocks of that height.
[[nodiscard]] LabelForm label_form(const PrintSettings& settings, double block_mm);

// The widest label.
[[nodiscard]] double widest_label(const std::vector<double>& values, const LabelForm& form);

// Beyond the part: brim and skirt, and a little.
[[nodiscard]] double margin_mm(const PrintSettings& settings);

// A spiral of one road, over a floor.
void set_vase(Calibration& calibration);

}  // namespace host
