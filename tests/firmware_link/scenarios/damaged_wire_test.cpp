#include "tools/faults/damaged_wire.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <span>
#include <string>

using namespace firmware_link;
using namespace std::chrono_literals;

namespace {

std::string taken(DamagedWire& wire, Instant now) {
  std::array<std::byte, 4096> bytes;
  std::string text;
  while (const std::size_t count = wire.take(bytes, now)) {
    text.append(reinterpret_cast<const char*>(bytes.data()), count);
  }
  return text;
}

// What comes of so many numbered lines.
std::string carried(const WireDamage& damage, std::uint64_t seed, int lines,
                    std::int64_t* damages = nullptr) {
  DamagedWire wire(damage, seed);
  std::string text;
  for (int i = 0; i < lines; ++i) {
    const std::string line = "N" + std::to_string(i) + "G1X1*12\n";
    wire.carry(std::as_bytes(std::span(line.data(), line.size())), Instant{});
    text += taken(wire, Instant{});
  }
  if (damages != nullptr) *damages = wire.damages();
  return text;
}

}  // namespace

TEST_CASE("a wire without damage carries all bytes as they are") {
  const std::string text = carried({}, 1, 3);
  CHECK(text == "N0G1X1*12\nN1G1X1*12\nN2G1X1*12\n");
}

TEST_CASE("each damage does what its name says, and the same again with the same seed") {
  const auto lines_in = [](const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
  };
  const std::string whole = carried({}, 7, 200);
  WireDamage damage;
  damage.distance = 20;
  std::int64_t damages = 0;
  const auto text_of = [&] {
    const std::string text = carried(damage, 7, 200, &damages);
    CHECK(text == carried(damage, 7, 200));
    CHECK(damages > 10);
    return text;
  };
  SUBCASE("lost bytes") {
    damage.lose_byte = 0.1;
    const std::string text = text_of();
    CHECK(text.size() == whole.size() - static_cast<std::size_t>(damages));
  }
  SUBCASE("doubled bytes") {
    damage.double_byte = 0.1;
    const std::string text = text_of();
    CHECK(text.size() == whole.size() + static_cast<std::size_t>(damages));
  }
  SUBCASE("flipped bits") {
    damage.flip_byte = 0.1;
    const std::string text = text_of();
    REQUIRE(text.size() == whole.size());
    std::int64_t differ = 0;
    for (std::size_t i = 0; i < text.size(); ++i) differ += text[i] != whole[i] ? 1 : 0;
    CHECK(differ == damages);
  }
  SUBCASE("lost lines") {
    damage.lose_line = 0.5;
    const std::string text = text_of();
    CHECK(lines_in(text) == 200 - damages);
  }
  SUBCASE("lost ends of line") {
    damage.lose_line_end = 0.5;
    const std::string text = text_of();
    CHECK(lines_in(text) == 200 - damages);
  }
  SUBCASE("doubled lines") {
    damage.double_line = 0.5;
    const std::string text = text_of();
    CHECK(lines_in(text) == 200 + damages);
  }
  SUBCASE("lines of nonsense") {
    damage.insert_line = 0.5;
    const std::string text = text_of();
    CHECK(lines_in(text) == 200 + damages);
  }
}

TEST_CASE("damages keep their distance") {
  WireDamage damage;
  damage.lose_byte = 1;
  damage.distance = 50;
  std::int64_t damages = 0;
  const std::string whole = carried({}, 3, 100);
  (void)carried(damage, 3, 100, &damages);
  CHECK(damages <= static_cast<std::int64_t>(whole.size()) / 50 + 1);
  CHECK(damages >= static_cast<std::int64_t>(whole.size()) / 50 - 1);
}

TEST_CASE("what is late holds up what is behind it") {
  WireDamage damage;
  damage.delay_line = 1;
  damage.delay_max = 10s;
  DamagedWire wire(damage, 5);
  const std::string line = "M105\n";
  wire.carry(std::as_bytes(std::span(line.data(), line.size())), Instant{});
  CHECK(wire.held_until() > Instant{});
  CHECK(wire.held_until() <= Instant(10s));
  CHECK(wire.arrived(Instant{}).empty());
  CHECK_FALSE(wire.empty());
  CHECK(taken(wire, wire.held_until()) == line);
  CHECK(wire.empty());
}
