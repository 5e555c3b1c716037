#include "host/pipeline/object_labels.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "firmware_link/wire/line_codec.h"
#include "host/output/gcode_writer.h"
#include "host/pipeline/object_map.h"

using core::Length;
using firmware_link::Flavor;
using host::ObjectLabels;
using Lines = std::vector<std::string>;

namespace {

core::Box box_mm(int x, int y, int side) {
  const int mm = 10'000;
  return {{x * mm, y * mm}, {(x + side) * mm, (y + side) * mm}};
}

std::vector<host::PartObject> two_objects() {
  return {{"clip_1", box_mm(10, 20, 30), Length::from_mm(5)},
          {"clip_2", box_mm(60, 20, 30), Length::from_mm(5)}};
}

ObjectLabels labels(core::ObjectLabels wanted, Flavor flavor) {
  core::Settings settings;
  settings.object_labels = wanted;
  settings.bed_origin_x = Length::from_mm(-100);
  return {two_objects(), settings, flavor};
}

}  // namespace

TEST_CASE("each firmware is told objects in its own words") {
  const ObjectLabels klipper = labels(core::ObjectLabels::kAuto, Flavor::kKlipper);
  CHECK_EQ(klipper.definitions(), Lines{"EXCLUDE_OBJECT_DEFINE NAME=clip_1 CENTER=-75,35",
                                        "EXCLUDE_OBJECT_DEFINE NAME=clip_2 CENTER=-25,35"});
  CHECK_EQ(klipper.start(1), "EXCLUDE_OBJECT_START NAME=clip_2");
  CHECK_EQ(klipper.end(1), "EXCLUDE_OBJECT_END NAME=clip_2");
  const ObjectLabels duet = labels(core::ObjectLabels::kAuto, Flavor::kRepRapFirmware);
  CHECK_EQ(duet.definitions(),
           Lines{"M486 T2", "M486 S0 A\"clip_1\"", "M486 S1 A\"clip_2\"", "M486 S-1"});
  const ObjectLabels marlin = labels(core::ObjectLabels::kFirmware, Flavor::kMarlin);
  CHECK_EQ(marlin.definitions(),
           Lines{"M486 T2", "M486 S0", "M486 Aclip_1", "M486 S1", "M486 Aclip_2", "M486 S-1"});
  CHECK_EQ(marlin.start(0), "M486 S0");
  CHECK_EQ(marlin.end(0), "M486 S-1");
}

TEST_CASE("a firmware that may not know objects is told only if asked to be") {
  using Wanted = core::ObjectLabels;
  for (const auto& silent :
       {labels(Wanted::kAuto, Flavor::kMarlin), labels(Wanted::kComments, Flavor::kKlipper),
        labels(Wanted::kOff, Flavor::kKlipper), ObjectLabels()}) {
    CHECK(silent.definitions().empty());
    CHECK(silent.start(0).empty());
    CHECK(silent.end(1).empty());
  }
}

TEST_CASE("every label may be sent, with the longest names") {
  std::vector<host::PartObject> objects = two_objects();
  for (host::PartObject& object : objects) object.name = std::string(24, 'w') + "_256";
  core::Settings settings;
  settings.object_labels = core::ObjectLabels::kFirmware;
  settings.bed_origin_x = settings.bed_origin_y = Length::from_mm(-2'500);
  for (const Flavor flavor : {Flavor::kMarlin, Flavor::kKlipper, Flavor::kRepRapFirmware}) {
    const ObjectLabels labels(objects, settings, flavor);
    Lines all = labels.definitions();
    all.push_back(labels.start(1));
    all.push_back(labels.end(1));
    for (const std::string& line : all) {
      CAPTURE(line);
      CHECK(std::holds_alternative<firmware_link::Verbatim>(firmware_link::verbatim_from(line)));
    }
  }
}

TEST_CASE("a file's comments tell where objects begin and end") {
  host::GcodeWriter writer;
  writer.name_objects({"clip_1", "clip_2"});
  std::string text;
  writer.write(core::ObjectStart{1}, std::nullopt, text);
  writer.write(core::ObjectEnd{1}, std::nullopt, text);
  writer.write(core::ObjectStart{2}, std::nullopt, text);  // nobody has named it
  CHECK_EQ(text,
           "; printing object clip_2 id:1 copy 0\n; stop printing object clip_2 id:1 copy 0\n");
}

TEST_CASE("a road belongs to the object whose box is nearest, a skirt to none") {
  const host::ObjectMap map(two_objects());
  CHECK_EQ(map.at({450'000, 300'000}), 0);
  CHECK_EQ(map.at({550'000, 300'000}), 1);
  CHECK_EQ(map.at({2'000'000, 0}), 1);
  CHECK_EQ(host::ObjectMap({}).at({0, 0}), core::kNoObject);
  const core::Ring line{{650'000, 300'000}, {700'000, 300'000}};
  std::vector<core::Road> roads = {{core::RoadKind::kBrim, Length::from_mm(0.4), false, line},
                                   {core::RoadKind::kSkirt, Length::from_mm(0.4), false, line}};
  map.mark(roads);
  CHECK_EQ(roads[0].object, 1);
  CHECK_EQ(roads[1].object, core::kNoObject);
}
