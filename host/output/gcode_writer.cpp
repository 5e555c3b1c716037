#include "host/output/gcode_writer.h"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <string_view>
#include <variant>

#include "firmware_link/wire/line_codec.h"

namespace host {

const char* prusa_type_name(core::RoadKind kind) {
  switch (kind) {
    case core::RoadKind::kSkirt:
      return "Skirt";
    case core::RoadKind::kOuterPerimeter:
      return "External perimeter";
    case core::RoadKind::kPerimeter:
      return "Perimeter";
    case core::RoadKind::kSolid:
      return "Solid infill";
    case core::RoadKind::kGapFill:
      return "Gap fill";
    case core::RoadKind::kLoose:
      return "Internal infill";
    case core::RoadKind::kBrim:
      return "Skirt/Brim";
    case core::RoadKind::kOverhangPerimeter:
      return "Overhang perimeter";
    case core::RoadKind::kTopSolid:
      return "Top solid infill";
    case core::RoadKind::kBottomSolid:
      return "Solid infill";
    case core::RoadKind::kBridge:
    case core::RoadKind::kInternalBridge:
      return "Bridge infill";
    case core::RoadKind::kIroning:
      return "Ironing";
    case core::RoadKind::kRaft:
    case core::RoadKind::kSupport:
      return "Support material";
    case core::RoadKind::kSupportInterface:
      return "Support material interface";
  }
  return "Custom";
}

namespace {

// In mm.
void write_length(std::string_view name, core::Length length, std::string& into) {
  std::array<char, 24> digits;
  const char* end = firmware_link::write_fixed(digits.data(), length.units(), 4);
  into.append(name).append(
      std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data()))) += '\n';
}

}  // namespace

void GcodeWriter::write(const core::Motion& motion,
                        const std::optional<firmware_link::Command>& command, std::string& into) {
  const auto out = std::back_inserter(into);
  if (const auto* layer = std::get_if<core::LayerStart>(&motion)) {
    fmt::format_to(out, ";LAYER_CHANGE\n;Z:{0}\n;HEIGHT:{1}\n;BEFORE_LAYER_CHANGE\n;{0}\n",
                   layer->top.mm(), layer->height.mm());
    layer_height_ = height_ = layer->height;
    kind_.reset();
  } else if (const auto* road = std::get_if<core::RoadStart>(&motion)) {
    write_road(road->kind, road->width, layer_height_ * road->layers, into);
  } else if (const auto* change = std::get_if<core::RoadChange>(&motion)) {
    write_road(change->kind, change->width, layer_height_, into);
  } else if (const auto* object = std::get_if<core::ObjectStart>(&motion)) {
    write_object(object->object, true, into);
  } else if (const auto* ended = std::get_if<core::ObjectEnd>(&motion)) {
    write_object(ended->object, false, into);
  } else if (std::holds_alternative<core::Pause>(motion)) {
    write_pause(into);
  }
  if (!command) return;
  firmware_link::TextBuffer text;
  into += firmware_link::encode(*command, text);
  into += '\n';
}

void GcodeWriter::write_object(int object, bool starts, std::string& into) const {
  const auto index = static_cast<std::size_t>(object);
  if (index >= objects_.size()) return;
  fmt::format_to(std::back_inserter(into), "; {} object {} id:{} copy 0\n",
                 starts ? "printing" : "stop printing", objects_[index], object);
}

void GcodeWriter::write_pause(std::string& into) const {
  into += ";PAUSE_PRINT\n";
  firmware_link::TextBuffer text;
  for (const std::string& line : pause_gcode_) {
    const auto made = firmware_link::verbatim_from(line);
    if (const auto* command = std::get_if<firmware_link::Verbatim>(&made)) {
      into += firmware_link::encode(*command, text);
      into += '\n';
    }
  }
}

void GcodeWriter::write_road(core::RoadKind kind, core::Length width, core::Length pressed,
                             std::string& into) {
  const core::Length height = kind == core::RoadKind::kBridge ? width : pressed;
  if (kind_ != kind) into.append(";TYPE:").append(prusa_type_name(kind)) += '\n';
  if (!kind_ || width_ != width) write_length(";WIDTH:", width, into);
  if (height_ != height) write_length(";HEIGHT:", height, into);
  kind_ = kind;
  width_ = width;
  height_ = height;
}

}  // namespace host
