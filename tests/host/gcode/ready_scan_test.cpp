// A whole file looked through: what is refused, with its line; what is told; what it sums up to.
#include "host/gcode/ready_scan.h"

#include <doctest/doctest.h>

#include <random>
#include <string>

#include "host/gcode/file_place.h"
#include "host/gcode/gcode_kind.h"
#include "host/gcode/ready_file.h"
#include "host/gcode/ready_reader.h"
#include "tests/support/part_folder.h"

using host::ReadySummary;

namespace {

host::ReadyFile file_of(const test::PartFolder& folder, const std::string& text) {
  auto bytes = host::FileBytes::open(folder.add_text("part.gcode", text));
  if (!bytes.ok()) FAIL(bytes.error().message);
  return {std::move(bytes).value(), false};
}

ReadySummary scanned(const std::string& text, const core::Settings& settings = {}) {
  const test::PartFolder folder;
  host::ReadyFile file = file_of(folder, text);
  const core::Status status = file.scan(settings, {});
  if (!status.ok()) FAIL(status.error().message);
  return file.summary();
}

std::string why_not(const std::string& text) {
  const test::PartFolder folder;
  host::ReadyFile file = file_of(folder, text);
  const core::Status status = file.scan({}, {});
  return status.ok() ? "" : status.error().message;
}

const std::string kStart = "M104 S200\nG28\nG90\nM83\nG1 X10 Y10 Z0.2 F1200\n";
const std::string kEnd = "M104 S0\n";

}  // namespace

TEST_CASE("what is refused is named with its line") {
  CHECK_NE(why_not(kStart + "G1 X20 E1\nM997\n").find("part.gcode: line 7 ('M997'): "),
           std::string::npos);
  CHECK_NE(why_not(kStart).find("no line of it lays any material"), std::string::npos);
  CHECK_NE(why_not("G1 X5 E1 F600\nM117 " + std::string(100, 'x') + "\n").find("line 2 ("),
           std::string::npos);
}

TEST_CASE("layers by comments, or by height; the box of what is in layers") {
  const std::string wiped = "G1 X10 Y-3 F600\nG1 X60 E9\n";
  const std::string two =
      "G1 X10 Y10 Z0.2\nG1 X20 E1\nG1 X20 Y20 E1\nLAYERG1 Z0.4\nG1 X10 Y20 E1\nG1 X10 Y10 E1\n";
  const auto with = [&two](const std::string& mark) {
    std::string text = two;
    return text.replace(text.find("LAYER"), 5, mark);
  };
  const ReadySummary plain = scanned(kStart + wiped + with("") + kEnd);
  CHECK_EQ(plain.layers, 2);
  CHECK_FALSE(plain.marks);
  CHECK_EQ(plain.box.min.y, -30'000);
  for (const std::string mark : {";LAYER_CHANGE\n", ";LAYER:1\n", "; CHANGE_LAYER\n"}) {
    const ReadySummary marked = scanned(kStart + wiped + mark + with(mark) + kEnd);
    CHECK_EQ(marked.layers, 2);
    CHECK(marked.marks);
    CHECK_EQ(marked.box.min.y, 100'000);
    CHECK_EQ(marked.box.max.x, 200'000);
    CHECK_EQ(marked.height, core::Length::from_mm(0.4));
    CHECK_EQ(marked.filament_mm, doctest::Approx(13));
  }
  core::Settings shifted_bed;
  shifted_bed.bed_origin_x = core::Length::from_mm(-50);
  CHECK_EQ(scanned(kStart + with("") + kEnd, shifted_bed).box.min.x, 600'000);
}

TEST_CASE("its time: as the slicer tells it, or by the clock") {
  const std::string roads = "G1 X110 E1 F600\nG1 X10 E1\n";
  const ReadySummary own = scanned(kStart + roads + kEnd);
  CHECK_FALSE(own.told_s);
  CHECK_EQ(own.seconds, doctest::Approx(20).epsilon(0.01));
  CHECK_GT(own.clock_s, 20);
  CHECK_LT(own.clock_s, 21);
  CHECK_EQ(
      scanned(kStart + roads + "; estimated printing time (normal mode) = 1d 2h 3m 4s\n").told_s,
      86'400 + 7'200 + 180 + 4);
  CHECK_EQ(scanned(";TIME:3723\n" + kStart + roads).told_s, 3'723);
  CHECK_EQ(scanned(kStart + "M73 P0 R62\n" + roads + "M73 P50 R31\n").told_s, 62 * 60);
  CHECK_EQ(
      scanned("; model printing time: 5s; total estimated time: 1m 5s\n" + kStart + roads).told_s,
      65);
}

TEST_CASE("what can't be resumed well is told") {
  const std::string road = "G1 X20 E1\n";
  CHECK(scanned(kStart + road + kEnd).unsafe.empty());
  CHECK(scanned(kStart + road + kEnd).warnings.empty());
  CHECK(scanned(kStart + road + kEnd).counts_filament);
  CHECK_EQ(scanned(kStart + road + "T1\n" + road + kEnd).unsafe.size(), 1);
  CHECK_EQ(scanned(kStart + "G92 X0\n" + road + kEnd).unsafe.size(), 1);
  CHECK_EQ(scanned("START_PRINT\n" + kStart + road + kEnd).unsafe.size(), 1);
  CHECK_EQ(scanned("G90\nM83\nG1 X1 F600\n" + road).unsafe.size(), 1);
  CHECK_EQ(scanned(kStart + "G10\nG11\n" + road + kEnd).unsafe.size(), 1);
  CHECK_FALSE(scanned(kStart + "M82\n" + road + kEnd).counts_filament);
  CHECK_EQ(scanned(kStart + road).warnings.size(), 1);  // still hot
  CHECK_EQ(scanned(kStart + "G90\n" + road + kEnd).warnings.size(), 1);
  CHECK_EQ(scanned(kStart + "G2 X20 I5 E1\n" + road + kEnd).first_arc_line, 6);
}

TEST_CASE("reading goes on from any command as if it had never stopped") {
  const std::uint64_t seed = std::random_device()();
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::string text = kStart + "M204 P500\n;LAYER_CHANGE\n";
  for (int i = 0; i < 400; ++i) {
    const char* modes[] = {"G91\nM83\n",      "G90\nM82\nG92 E1.5\n", "M204 T900\n",
                           ";LAYER_CHANGE\n", "; nothing\n\n",        "M106 S77\r\n"};
    if (random() % 6 == 0) text += modes[random() % 6];
    text += "G1 X" + std::to_string(random() % 100) + " Y5 E" + std::to_string(random() % 3) + "\n";
  }
  const test::PartFolder folder;
  host::ReadyFile file = file_of(folder, text);
  const auto whole_text = file.text();
  host::ReadyReader whole(*whole_text, {}, true);
  std::vector<host::FilePlace> before, behind;
  std::vector<std::string> words;
  while (true) {
    const auto read = whole.next();
    REQUIRE(read.ok());
    if (!read.value()) break;
    before.push_back(whole.before());
    behind.push_back(whole.behind());
    words.emplace_back(read.value()->meaning.line.words.text());
  }
  for (int i = 0; i < 30; ++i) {
    const std::size_t from = random() % before.size();
    CAPTURE(from);
    const std::string kept = host::bytes_of(before[from]);
    CHECK_LE(kept.size(), host::kPlaceBytesMax);
    const auto place = host::place_of(kept);
    REQUIRE(place.has_value());
    CHECK_EQ(host::bytes_of(*place), kept);
    const auto again = file.text();
    REQUIRE(again->go_to(place->text).ok());
    host::ReadyReader rest(*again, {}, true, *place);
    for (std::size_t n = from; n < words.size(); ++n) {
      const auto read = rest.next();
      REQUIRE(read.ok());
      REQUIRE(read.value().has_value());
      REQUIRE_EQ(std::string(read.value()->meaning.line.words.text()), words[n]);
      REQUIRE_EQ(host::bytes_of(rest.behind()), host::bytes_of(behind[n]));
      REQUIRE_EQ(rest.before().set_up, before[n].set_up);
    }
  }
}

TEST_CASE("G-code is known by its content") {
  using host::GcodeKind;
  const auto kind = [](const std::string& bytes) {
    host::InputFile file = host::InputFile::from_bytes("x", bytes);
    const auto found = host::gcode_kind(file);
    REQUIRE(found.ok());
    return found.value();
  };
  CHECK_EQ(kind("G28\nG1 X5\n"), GcodeKind::kText);
  CHECK_EQ(kind("; generated\n\n  M104 S200"), GcodeKind::kText);
  CHECK_EQ(kind("START_PRINT BED=60\nG1 X5\n"), GcodeKind::kText);
  CHECK_EQ(kind(";" + std::string(20'000, 'a') + "\nT0\n"), GcodeKind::kText);
  CHECK_EQ(kind("; " + std::string(400'000, 'a')), GcodeKind::kText);
  CHECK_EQ(kind("GCDE\1"), GcodeKind::kBinary);
  for (const char* other : {"solid x\nfacet", "v 1 2 3\n", "g part\nv 1 2 3\n", "$$HEADERSTART",
                            "; only a comment", "", "START_PRINT\nsolid", "(SIF_SFF", "<svg"}) {
    CHECK_FALSE(kind(other).has_value());
  }
}
