#include "host/pipeline/hanging_log.h"

#include <doctest/doctest.h>

#include <string>

using core::HangingKind;
using core::HangingPlaces;
using core::Length;

namespace {

HangingPlaces islands(int count, double area) {
  HangingPlaces places;
  places.counts[0] = count;
  for (int i = 0; i < count; ++i) {
    places.largest.push_back({HangingKind::kIsland, {1'600'000, 1'500'000}, area - i});
  }
  return places;
}

}  // namespace

TEST_CASE("a place is named with its layer, where it is, and its size") {
  host::HangingLog log;
  CHECK(log.summary().empty());
  log.add(50, Length::from_mm(10), islands(1, 25));
  CHECK_FALSE(log.summary().empty());
  REQUIRE_EQ(log.summary().size(), 1);
  CHECK_EQ(log.summary().front(),
           "1 island begins in the air: 25.0 mm² at (160.0, 150.0) mm on the bed, layer 51, "
           "10 mm high");
}

TEST_CASE("only the first places are named, all are counted, the largest is told") {
  host::HangingLog log;
  for (int layer = 1; layer <= 100; ++layer) {
    HangingPlaces places = islands(2, 10 + layer);
    places.counts[1] = 1;
    places.largest.push_back({HangingKind::kSpan, {0, 0}, 12});
    log.add(layer, Length::from_mm(0.2 * layer), places);
  }
  const host::HangingLog::Kind& found = log.of(HangingKind::kIsland);
  CHECK_EQ(found.count, 200);
  CHECK_EQ(found.layers, 100);
  CHECK_EQ(found.first.size(), host::kHangingTold);
  CHECK_EQ(found.largest.layer, 100);
  const std::vector<std::string> lines = log.summary();
  REQUIRE_EQ(lines.size(), 2);
  CHECK(lines.front().starts_with("200 islands begin in the air, in 100 layers: 11.0 mm² at "));
  CHECK(
      lines.front().ends_with("the largest 110.0 mm² at (160.0, 150.0) mm on the bed, layer 101, "
                              "20 mm high"));
  CHECK(lines.back().starts_with("100 bridges are longer than bridge_max, in 100 layers: 12.0 mm"));
}

TEST_CASE("the option's words are read back") {
  for (const host::OnFloating action : {host::OnFloating::kWarn, host::OnFloating::kStop}) {
    CHECK_EQ(host::floating_of(host::floating_word(action)), action);
  }
  CHECK_EQ(host::floating_of(""), host::OnFloating::kWarn);
}
