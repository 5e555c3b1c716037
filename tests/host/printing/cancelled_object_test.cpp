// Objects that are cancelled while they are printed: nothing more of them is laid, and the others
// are laid as if nothing had happened.
#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/part/plate.h"
#include "host/system/exit_codes.h"
#include "tests/host/interrupted_print.h"
#include "tests/support/laid_roads.h"
#include "tests/support/part_folder.h"

using print_test::coarse;
using print_test::Rig;
using test::LaidPiece;
using test::PartFolder;

namespace {

core::Settings three_copies() {
  core::Settings settings = coarse();
  settings.copies = 3;
  settings.skirt_loops = 0;
  settings.object_labels = core::ObjectLabels::kFirmware;
  return settings;
}

host::PrintPlan open_plate(const core::Settings& settings, const std::string& path) {
  auto part = host::read_whole(host::open_plate({path}, settings, {}));
  if (!part.ok()) FAIL(part.error().message);
  return {settings, std::move(part).value(), path};
}

bool is_in(const core::Box& box, const LaidPiece& piece) {
  const double x = piece.to[0] * core::kUnitsPerMm, y = piece.to[1] * core::kUnitsPerMm;
  return x >= box.min.x && x <= box.max.x && y >= box.min.y && y <= box.max.y;
}

std::vector<LaidPiece> laid_in(const core::Box& box, const std::vector<std::string>& lines) {
  std::vector<LaidPiece> pieces = test::laid_by(lines);
  std::erase_if(pieces, [&box](const LaidPiece& piece) { return !is_in(box, piece); });
  return pieces;
}

double filament_of(const std::vector<LaidPiece>& pieces) {
  double sum = 0;
  for (const LaidPiece& piece : pieces) sum += piece.filament;
  return sum;
}

// Filament that came out, or was drawn back, without a road, mm.
double pushed_besides(const Rig& rig) {
  const auto all = static_cast<double>(rig.port->controller().totals().filament_10nm) * 1e-5;
  return all - filament_of(test::laid_by(rig.executed));
}

// Asks once, when so many commands have been executed.
struct Asker {
  Rig& rig;
  std::size_t after;
  int object;
  bool asked = false;

  std::optional<int> operator()() {
    if (asked || rig.executed.size() < after) return std::nullopt;
    asked = true;
    return object;
  }
};

}  // namespace

TEST_CASE("of a cancelled object nothing more is laid, and the others are whole") {
  const PartFolder folder;
  const std::string path = print_test::small_part(folder);
  const core::Settings settings = three_copies();
  Rig whole(settings, open_plate(settings, path));
  const std::vector<host::PartObject> objects = whole.print_plan.part.summary.objects;
  REQUIRE_EQ(whole.print().exit_code, host::kExitDone);
  CHECK_GT(whole.count("M486 S1"), 5);
  for (const std::size_t after : {std::size_t{150}, whole.executed.size() / 2}) {
    CAPTURE(after);
    Rig rig(settings, open_plate(settings, path));
    rig.control.cancelled = Asker{rig, after, 2};
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitDone);
    for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
      // An object's last move gets what rounding left of the one before it.
      CHECK(filament_of(laid_in(objects[i].box, rig.executed)) ==
            doctest::Approx(filament_of(laid_in(objects[i].box, whole.executed))).epsilon(1e-3));
    }
    // No blob: what was not laid was not pushed out anywhere else.
    CHECK(pushed_besides(rig) == doctest::Approx(pushed_besides(whole)).epsilon(1e-6));
    // What the session and the controller had in hand is laid, nothing else.
    constexpr std::size_t kInHand = 64;
    const std::vector<std::string> then(
        rig.executed.begin() + static_cast<std::ptrdiff_t>(after + kInHand), rig.executed.end());
    CHECK_FALSE(laid_in(objects[1].box, rig.executed).empty());
    CHECK(laid_in(objects[1].box, then).empty());
  }
}

TEST_CASE("when all objects are cancelled, the print ends safely") {
  const PartFolder folder;
  const core::Settings settings = three_copies();
  Rig rig(settings, open_plate(settings, print_test::small_part(folder)));
  int next = 1;
  rig.control.cancelled = [&]() -> std::optional<int> {
    if (rig.executed.size() < 100 || next > 3) return std::nullopt;
    return next++;
  };
  CHECK_EQ(rig.print().exit_code, host::kExitStopped);
  CHECK_EQ(rig.controller().nozzle_target_celsius, 0);
}

TEST_CASE("a number that no object has cancels nothing") {
  const PartFolder folder;
  const core::Settings settings = three_copies();
  Rig rig(settings, open_plate(settings, print_test::small_part(folder)));
  rig.control.cancelled = Asker{rig, 100, 4};
  const host::PrintOutcome outcome = rig.print();
  CHECK_EQ(outcome.exit_code, host::kExitDone);
}

TEST_CASE("a resumed print leaves out what was cancelled before it was cut") {
  const PartFolder folder;
  const std::string path = print_test::small_part(folder);
  const core::Settings settings = three_copies();
  for (const std::size_t more : {80U, 400U, 900U}) {
    CAPTURE(more);
    Rig rig(settings, open_plate(settings, path));
    const std::vector<host::PartObject> objects = rig.print_plan.part.summary.objects;
    const std::string journal_path = folder.file("print.journal" + std::to_string(more));
    auto journal = print_test::new_journal(journal_path);
    REQUIRE(journal.ok());
    {
      host::Journal kept = std::move(journal).value();
      rig.control.kept_journal = &kept;
      rig.control.cancelled = Asker{rig, 200, 2};
      rig.on_executed = [&] {
        if (rig.executed.size() == 200 + more) rig.wire->unplug();
      };
      CHECK_EQ(rig.print().exit_code, host::kExitLinkFault);
    }
    rig.on_executed = nullptr;
    rig.control.cancelled = nullptr;
    const auto read = host::read_journal(journal_path);
    REQUIRE(read.ok());
    REQUIRE_EQ(read.value().record.cancelled.size(), 1);
    core::Result<host::Journal> again = host::Journal::reopen(journal_path);
    REQUIRE(again.ok());
    rig.wire = std::make_unique<print_test::BreakablePort>(*rig.port);
    rig.print_plan = open_plate(settings, path);
    rig.control.kept_journal = &again.value();
    const std::size_t before = rig.executed.size();
    rig.options.resumption =
        host::Resumption{read.value().record, true, read.value().record.nozzle_z_um};
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitDone);
    const std::vector<std::string> rest(rig.executed.begin() + static_cast<std::ptrdiff_t>(before),
                                        rig.executed.end());
    CHECK(laid_in(objects[1].box, rest).empty());
    CHECK_FALSE(laid_in(objects[0].box, rest).empty());
  }
}
