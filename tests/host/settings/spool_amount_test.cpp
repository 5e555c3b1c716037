#include "host/settings/spool_amount.h"

#include <doctest/doctest.h>

#include <numbers>
#include <string>

namespace {

host::SpoolAmount amount(const std::string& text) {
  const auto read = host::spool_amount(text);
  if (!read.ok()) FAIL(read.error().message);
  return read.value();
}

}  // namespace

TEST_CASE("lengths and weights, each in two units") {
  CHECK_EQ(amount("12 m").mm, 12'000);
  CHECK_EQ(amount(" 0.5m ").mm, 500);
  CHECK_EQ(amount("900 mm").mm, 900);
  CHECK_EQ(amount("0m").mm, 0);
  CHECK_EQ(amount("350 g").grams, 350);
  CHECK_EQ(amount("0.4kg").grams, doctest::Approx(400));
  CHECK_EQ(amount("350 g").mm, 0);
  CHECK_EQ(amount("12 m").grams, 0);
}

TEST_CASE("what is no amount") {
  for (const char* text :
       {"12", "", "m", "-1 m", "12 cm", "1 m m", "1 kg g", "nan m", "12 m 3 g"}) {
    CAPTURE(text);
    const auto read = host::spool_amount(text);
    REQUIRE_FALSE(read.ok());
    CHECK(read.error().message.starts_with("'" + std::string(text) + "' is no amount"));
  }
}

TEST_CASE("a weight is a length by the filament's density and diameter") {
  core::Settings settings;
  settings.filament_density_g_cm3 = 1.27;
  settings.filament_diameter = core::Length::from_mm(2.85);
  const double grams_per_m = std::numbers::pi * 0.1425 * 0.1425 * 100 * 1.27;
  CHECK_EQ(host::spool_mm({0, 5 * grams_per_m}, settings).value(), doctest::Approx(5'000));
  CHECK_EQ(host::spool_mm({70, 0}, settings).value(), 70);
  settings.filament_density_g_cm3 = 0;
  CHECK_EQ(host::spool_mm({70, 0}, settings).value(), 70);
  CHECK_FALSE(host::spool_mm({0, 70}, settings).ok());
}
