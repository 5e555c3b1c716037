#include "host/output/gcode_writer.h"

#include <doctest/doctest.h>

#include <string>

#include "host/pipeline/motion_encoder.h"

using core::Length;
using core::RoadKind;

namespace {

std::string written(const std::vector<core::Motion>& motions) {
  host::MotionEncoder encoder;
  host::GcodeWriter writer;
  std::string text;
  for (const core::Motion& motion : motions) {
    writer.write(motion, encoder.encode(motion), text);
  }
  return text;
}

const core::RoadStart kPerimeter{RoadKind::kOuterPerimeter, Length::from_mm(0.45)};
const core::RoadStart kGapFill{RoadKind::kGapFill, Length::from_mm(0.3)};

}  // namespace

TEST_CASE("layers and roads carry the comments that PrusaSlicer's viewer reads") {
  CHECK_EQ(written({core::LayerStart{0, Length::from_mm(0.2), Length::from_mm(0.2)}, kPerimeter,
                    core::Extrude{{10'000, 0}, 0.05, 30}, kPerimeter, kGapFill,
                    core::Extrude{{20'000, 0}, 0.05, 30},
                    core::LayerStart{1, Length::from_mm(0.4), Length::from_mm(0.2)}, kGapFill}),
           ";LAYER_CHANGE\n;Z:0.2\n;HEIGHT:0.2\n;BEFORE_LAYER_CHANGE\n;0.2\n"
           ";TYPE:External perimeter\n;WIDTH:0.45\nG1 X1 Y0 E0.05 F1800\n"
           ";TYPE:Gap fill\n;WIDTH:0.3\nG1 X2 E0.05\n"
           ";LAYER_CHANGE\n;Z:0.4\n;HEIGHT:0.2\n;BEFORE_LAYER_CHANGE\n;0.4\n;TYPE:Gap "
           "fill\n;WIDTH:0.3\n");
}

TEST_CASE("a bridge is as high as it is wide, and a road may go on as another kind") {
  const core::RoadStart bridge{RoadKind::kBridge, Length::from_mm(0.32)};
  const core::RoadChange overhang{RoadKind::kOverhangPerimeter, Length::from_mm(0.45)};
  CHECK_EQ(written({core::LayerStart{0, Length::from_mm(0.2), Length::from_mm(0.2)}, bridge, bridge,
                    kPerimeter, overhang}),
           ";LAYER_CHANGE\n;Z:0.2\n;HEIGHT:0.2\n;BEFORE_LAYER_CHANGE\n;0.2\n"
           ";TYPE:Bridge infill\n;WIDTH:0.32\n;HEIGHT:0.32\n"
           ";TYPE:External perimeter\n;WIDTH:0.45\n;HEIGHT:0.2\n;TYPE:Overhang perimeter\n");
}

TEST_CASE("heights are exact however tall the part") {
  CHECK_EQ(written({core::LayerStart{9, Length::from_mm(123'456.7891), Length::from_mm(0.05)}}),
           ";LAYER_CHANGE\n;Z:123456.7891\n;HEIGHT:0.05\n;BEFORE_LAYER_CHANGE\n;123456.7891\n");
}

TEST_CASE("every kind of road has a name that PrusaSlicer knows") {
  CHECK_EQ(std::string(host::prusa_type_name(RoadKind::kSkirt)), "Skirt");
  CHECK_EQ(std::string(host::prusa_type_name(RoadKind::kPerimeter)), "Perimeter");
  CHECK_EQ(std::string(host::prusa_type_name(RoadKind::kSolid)), "Solid infill");
  CHECK_EQ(std::string(host::prusa_type_name(RoadKind::kLoose)), "Internal infill");
  CHECK_EQ(std::string(host::prusa_type_name(RoadKind::kRaft)), "Support material");
}
