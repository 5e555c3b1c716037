// What happens before the first slice of a large part, and to layers that are not to be trusted.
#include <doctest/doctest.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "host/part/bad_layers.h"
#include "host/part/mesh_layers.h"
#include "host/system/exit_codes.h"
#include "tests/host/print_rig.h"
#include "tests/support/laid_roads.h"
#include "tests/support/listed_triangles.h"
#include "tests/support/mesh.h"
#include "tests/support/region_text.h"

using core::Length;
using core::Slice;
using core::Triangle;
using print_test::Rig;

namespace {

constexpr std::size_t kLookAhead = 50;

class Gate {
 public:
  void open() {
    const std::lock_guard lock(mutex_);
    open_ = true;
    changed_.notify_all();
  }
  // False after a time that is long for any machine.
  [[nodiscard]] bool wait() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(60), [this] { return open_; });
  }

 private:
  std::mutex mutex_;  // protects all below
  std::condition_variable changed_;
  bool open_ = false;
};

// Gives `free` triangles, then waits at a gate.
class HeldTriangles : public host::TriangleSource {
 public:
  HeldTriangles(std::vector<Triangle> triangles, std::size_t free, Gate& gate, bool fails)
      : triangles_(std::move(triangles)), free_(free), gate_(gate), fails_(fails) {}

  [[nodiscard]] std::string format() const override { return "list"; }
  [[nodiscard]] core::Result<std::optional<Triangle>> next() override {
    if (next_ == free_) {
      // A print that does not heat before it has read all fails here.
      if (!gate_.wait()) return core::Error{core::ErrorCode::kUnreadable, "nobody let go"};
      if (fails_) return core::Error{core::ErrorCode::kUnreadable, "list: cut off"};
    }
    if (next_ == triangles_.size()) return std::optional<Triangle>();
    ++facets_;
    return std::optional<Triangle>(triangles_[next_++]);
  }

 private:
  std::vector<Triangle> triangles_;
  std::size_t free_;
  Gate& gate_;
  bool fails_;
  std::size_t next_ = 0;
};

std::vector<Triangle> dome() { return test::triangles_of(parts::dome(6, 64, 24)); }

host::PrintPlan plan_of(host::MeshInput mesh, const core::Settings& settings,
                        host::PlaneCheck check = host::PlaneCheck::kNone) {
  host::OpenOptions options;
  options.reorder_triangles = kLookAhead;
  options.plane_check = check;
  auto part = host::open_mesh(std::move(mesh), settings, options);
  REQUIRE_MESSAGE(part.ok(), (part.ok() ? "" : part.error().message));
  return {settings, std::move(part).value(), "list"};
}

// With a facet that has no neighbours beside it, from 4 to 4.3 mm.
std::vector<Triangle> torn_dome() {
  std::vector<Triangle> triangles = dome();
  triangles.push_back({{core::Vertex{0, 0, 40'000}, {0, 80'000, 40'000}, {0, 0, 43'000}}});
  return triangles;
}

// A print whose part is read to its end only when the heaters are on.
struct HeldPrint {
  explicit HeldPrint(bool fails) {
    const core::Settings settings;
    // More than a look ahead and its batches are free: the rest is read in the print.
    auto held = std::make_unique<HeldTriangles>(dome(), 2'000, gate, fails);
    rig = std::make_unique<Rig>(settings, plan_of({"list", std::move(held), {}}, settings));
    REQUIRE(rig->print_plan.part.read_rest);
    rig->on_executed = [this] {
      if (rig->count("M104 S210") > 0 && rig->count("M140 S60") > 0) gate.open();
    };
    outcome = rig->print();
  }

  Gate gate;
  std::unique_ptr<Rig> rig;
  host::PrintOutcome outcome;
};

Slice slice_of(core::LayerIndex index, const char* region, std::int64_t dropped) {
  Slice slice;
  slice.index = index;
  slice.height = Length::from_mm(0.2);
  slice.bottom = slice.height * index;
  slice.region = test::region_from_text(region);
  slice.defects.dropped_chains = dropped;
  return slice;
}

}  // namespace

TEST_CASE("the heaters are on while the mesh is still being read") {
  HeldPrint print(false);
  const std::unique_ptr<Rig>& rig = print.rig;
  const host::PrintOutcome& outcome = print.outcome;
  CAPTURE(outcome.message);
  CHECK_EQ(outcome.exit_code, host::kExitDone);
  CHECK_EQ(outcome.geometry.layers, 30);
  // Once, and before anything moves.
  CHECK_EQ(rig->count("M104 S210"), 1);
  CHECK_EQ(rig->count("M140 S60"), 1);
  CHECK_EQ(rig->controller().nozzle_target_celsius, 0);
}

TEST_CASE("a mesh that breaks off while the heaters are on cools down, and nothing has moved") {
  HeldPrint print(true);
  const std::unique_ptr<Rig>& rig = print.rig;
  const host::PrintOutcome& outcome = print.outcome;
  CAPTURE(outcome.message);
  CHECK_EQ(outcome.exit_code, host::kExitBadInput);
  CHECK_NE(outcome.message.find("cut off"), std::string::npos);
  CHECK_EQ(rig->controller().nozzle_target_celsius, 0);
  CHECK_EQ(rig->controller().bed_target_celsius, 0);
  for (const char* move : {"G0", "G1", "G28"}) CHECK_EQ(rig->count(move), 0);
}

TEST_CASE("contours that stay open are found before anything moves") {
  const core::Settings settings;
  std::vector<Triangle> triangles = dome();
  // Single walls standing about: nothing can close them.
  for (int i = 0; i < 3; ++i) {
    const int x = 200'000 + 90'000 * i;
    triangles.push_back({{core::Vertex{x, 0, 12'000}, {x, 80'000, 12'000}, {x, 0, 15'000}}});
  }
  for (const bool pipe : {false, true}) {
    CAPTURE(pipe);
    const auto opened = [&](host::PlaneCheck check) {
      host::PrintPlan print_plan =
          plan_of(test::listed_mesh(triangles, pipe).input, settings, check);
      return print_plan.part.read_rest();
    };
    const auto refused = opened(host::PlaneCheck::kRefuse);
    REQUIRE_FALSE(refused.ok());
    CAPTURE(refused.error().message);
    CHECK_NE(refused.error().message.find("the first is layer 7"), std::string::npos);
    const auto warned = opened(host::PlaneCheck::kWarn);
    REQUIRE(warned.ok());
    REQUIRE_EQ(warned.value().warnings.size(), 1);
    CHECK_NE(warned.value().warnings[0].find("layer 7"), std::string::npos);
    CHECK(opened(host::PlaneCheck::kNone).value().warnings.empty());
  }
  // The check reads the part a further time and leaves nothing behind.
  host::PrintPlan checked =
      plan_of(test::listed_mesh(triangles, false).input, settings, host::PlaneCheck::kWarn);
  host::PrintPlan plain = plan_of(test::listed_mesh(triangles, false).input, settings);
  REQUIRE(checked.part.read_rest().ok());
  REQUIRE(plain.part.read_rest().ok());
  for (int layer = 0; layer < 30; ++layer) {
    const auto a = checked.part.layers->next(), b = plain.part.layers->next();
    REQUIRE(a.ok());
    REQUIRE(b.ok());
    CHECK_EQ(a.value()->region, b.value()->region);
    CHECK_EQ(a.value()->defects.dropped_chains, b.value()->defects.dropped_chains);
  }
}

TEST_CASE("a bad layer is told with its height and treated as asked for") {
  using host::OnBadLayer;
  const char* square = "0:0 5:0 5:5 0:5";
  for (const OnBadLayer action :
       {OnBadLayer::kRepair, OnBadLayer::kNeighbour, OnBadLayer::kPause, OnBadLayer::kStop}) {
    CAPTURE(static_cast<int>(action));
    host::WarningBox warnings;
    host::BadLayers layers(action, "part", warnings);
    Slice good = slice_of(0, square, 0), open = slice_of(1, "0:0 1:0 1:1", 2);
    Slice nothing = slice_of(2, "", 0), last = slice_of(3, "", 0);
    REQUIRE(layers.check(good, 4).ok());
    const auto checked = layers.check(open, 4);
    const bool ends = action == OnBadLayer::kStop;
    REQUIRE_EQ(checked.ok(), !ends);
    if (ends) {
      CHECK_NE(checked.error().message.find("layer 2 at 0.4 mm: 2 open contours"),
               std::string::npos);
      continue;
    }
    CHECK_EQ(checked.value().has_value(), action == OnBadLayer::kPause);
    REQUIRE(layers.check(nothing, 4).ok());
    REQUIRE(layers.check(last, 4).ok());
    const bool copies = action == OnBadLayer::kNeighbour;
    CHECK_EQ(open.region == good.region, copies);
    CHECK_EQ(nothing.region == good.region, copies);
    CHECK(last.region.empty());
    CHECK_EQ(layers.count(), 2);
    const std::vector<std::string> told = warnings.take();
    REQUIRE_EQ(told.size(), 2);
    CHECK_NE(told[1].find("layer 3 at 0.6 mm: it is empty"), std::string::npos);
    CHECK(warnings.take().empty());
  }
}

TEST_CASE("a bad layer in mid-print ends with the nozzle off the part, if so asked for") {
  const core::Settings settings;
  Rig rig(settings, plan_of(test::listed_mesh(torn_dome(), false).input, settings));
  rig.print_plan.on_bad_layer = host::OnBadLayer::kStop;
  const host::PrintOutcome outcome = rig.print();
  CAPTURE(outcome.message);
  CHECK_EQ(outcome.exit_code, host::kExitBadInput);
  CHECK_NE(outcome.message.find("open contour"), std::string::npos);
  CHECK_EQ(rig.controller().nozzle_target_celsius, 0);
  CHECK_GT(rig.controller().z_mm, 10);  // park_lift
}

TEST_CASE("a bad layer in mid-print waits for its user off the part, and resumes as repaired") {
  const core::Settings settings;
  std::vector<test::LaidPiece> repaired;
  for (const auto action : {host::OnBadLayer::kRepair, host::OnBadLayer::kPause}) {
    Rig rig(settings, plan_of(test::listed_mesh(torn_dome(), false).input, settings));
    rig.print_plan.on_bad_layer = action;
    int waited = 0;
    bool away = false;
    rig.control.request = [&]() -> std::optional<host::UserRequest> {
      const auto state = rig.controller();
      // The end parks there, too, above the whole part.
      const bool off_part =
          state.z_mm > 10 && state.z_mm < 15.5 && state.x_mm == 5 && state.y_mm == 5;
      const bool waits = off_part && !away;
      away = off_part;
      if (!waits) return std::nullopt;
      ++waited;
      return host::UserRequest::kResume;
    };
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitDone);
    CHECK_GT(outcome.geometry.bad_layers, 0);
    const std::vector<test::LaidPiece> laid = test::laid_by(rig.executed);
    if (action == host::OnBadLayer::kRepair) {
      repaired = laid;
      CHECK_EQ(waited, 0);
      continue;
    }
    CHECK_EQ(waited, outcome.geometry.bad_layers);
    CHECK_EQ(laid.size(), repaired.size());
    CHECK(laid == repaired);
    CHECK_EQ(rig.controller().nozzle_target_celsius, 0);
  }
}
