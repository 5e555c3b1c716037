#include "host/calibration/calibration_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace host {
namespace {

constexpr double kBase_mm = 1;
constexpr double kNotch_mm = 0.6;      // how high a groove is
constexpr double kNotchDeep_mm = 0.4;  // and how deep

constexpr double kLabelBlockMost_mm = 7;  // higher digits are no easier to read

int layers_of(core::Length height, double mm) {
  return std::max(1, static_cast<int>(std::lround(mm / height.mm())));
}

}  // namespace

double in_layers(const PrintSettings& settings, double mm) {
  return settings.layer_height.mm() * layers_of(settings.layer_height, mm);
}

std::vector<CalibrationBlock> blocks_of(const PrintSettings& settings,
                                        const std::vector<double>& values, double block_mm) {
  const core::Length height = settings.layer_height;
  const bool own = settings.first_layer_height > core::Length();
  const core::Length first = own ? settings.first_layer_height : height;
  core::Length at = first + height * (layers_of(height, kBase_mm) - 1);
  const core::Length block = height * layers_of(height, block_mm);
  std::vector<CalibrationBlock> blocks;
  blocks.reserve(values.size());
  for (const double value : values) {
    blocks.push_back({at, at + block, value});
    at = at + block;
  }
  return blocks;
}

void vary(std::string_view key, std::string_view unit, std::vector<CalibrationBlock> blocks,
          const PrintSettings& settings, Calibration& calibration) {
  std::vector<std::string>& lines = calibration.at_height;
  lines = settings.at_height;
  lines.reserve(lines.size() + blocks.size());
  for (const CalibrationBlock& block : blocks) {
    lines.push_back(fmt::format("{} {} {}", block.bottom.mm(), key, block.value));
  }
  calibration.key = key;
  calibration.unit = unit;
  calibration.blocks = std::move(blocks);
}

void add_notched_column(const PrintSettings& settings, const std::vector<CalibrationBlock>& blocks,
                        Span x, Span y, TestSolid& solid) {
  const double notch = in_layers(settings, kNotch_mm), layer = settings.layer_height.mm();
  for (const CalibrationBlock& block : blocks) {
    const double bottom = block.bottom.mm(), top = block.top.mm();
    solid.box({x.from + kNotchDeep_mm, x.to - kNotchDeep_mm},
              {y.from + kNotchDeep_mm, y.to - kNotchDeep_mm},
              {bottom - layer, bottom + notch + layer});
    solid.box(x, y, {bottom + notch, top});
  }
}

void add_labels(const PrintSettings& settings, const std::vector<CalibrationBlock>& blocks,
                Place at, LabelSide side, const LabelForm& form, TestSolid& solid) {
  const double notch = in_layers(settings, kNotch_mm);
  for (const CalibrationBlock& block : blocks) {
    const double bottom = block.bottom.mm() + notch;
    const double room = block.top.mm() - bottom - form.height;
    solid.label(fmt::format("{:g}", block.value), at.u, at.v,
                bottom + in_layers(settings, room / 2), side, form);
  }
}

LabelForm label_form(const PrintSettings& settings, double block_mm) {
  LabelForm form;
  block_mm = std::min(block_mm, kLabelBlockMost_mm);
  form.thick = in_layers(settings, 0.18 * (block_mm - kNotch_mm - 1));
  form.height =
      3 * form.thick + 2 * in_layers(settings, (block_mm - kNotch_mm - 1) / 2 - 1.5 * form.thick);
  form.stroke = 2.1 * settings.road_width.mm();
  form.raised = 1.4 * settings.road_width.mm();
  return form;
}

double widest_label(const std::vector<double>& values, const LabelForm& form) {
  double widest = 0;
  for (const double value : values) {
    widest = std::max(widest, label_width(fmt::format("{:g}", value), form));
  }
  return widest;
}

double margin_mm(const PrintSettings& settings) {
  const bool brim = settings.brim_width > core::Length();
  const double beyond_brim = brim ? (settings.brim_gap + settings.brim_width).mm() : 0;
  if (settings.skirt_loops == 0) return beyond_brim + 1;
  return beyond_brim + settings.skirt_distance.mm() +
         (settings.skirt_loops + 1) * settings.road_width.mm() * 1.2 + 1;
}

void set_vase(Calibration& calibration) {
  calibration.settings.emplace_back("spiral_vase", "1");
  calibration.settings.emplace_back("loose_roof", "off");
}

}  // namespace host
