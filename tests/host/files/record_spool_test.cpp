#include "host/files/record_spool.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "host/system/limits.h"
#include "tests/support/random_regions.h"
#include "tests/support/temporary_folder.h"

namespace {

constexpr host::SpillUse kUse{"a test", "do nothing"};

std::vector<std::string> random_records(std::uint64_t seed) {
  test::Random random(seed);
  std::vector<std::string> records;
  const int count = random.integer(0, 300);
  for (int i = 0; i < count; ++i) {
    const int kind = random.integer(0, 9);
    const int size = kind == 0 ? random.integer(50'000, 200'000) : random.integer(0, 700);
    std::string record(static_cast<std::size_t>(size), '\0');
    for (char& byte : record) byte = static_cast<char>(random.integer(0, 255));
    records.push_back(std::move(record));
  }
  return records;
}

}  // namespace

TEST_CASE("records come back as they were, from either end, in any turn, and by their place") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const std::vector<std::string> records = random_records(seed);
    auto made = host::RecordSpool::create("", kUse);
    REQUIRE(made.ok());
    host::RecordSpool spool = std::move(made).value();
    std::vector<std::int64_t> places;
    for (const std::string& record : records) {
      places.push_back(spool.next_place());
      REQUIRE(spool.append(record).ok());
    }
    spool.go_to_end();
    for (std::size_t i = records.size(); i-- > 0;) {
      const auto record = spool.previous();
      REQUIRE(record.ok());
      REQUIRE(record.value().has_value());
      CHECK(record.value()->bytes == records[i]);
      CHECK_EQ(record.value()->at, places[i]);
    }
    CHECK_FALSE(spool.previous().value().has_value());
    spool.go_to_start();
    test::Random random(seed);
    std::size_t at = 0;
    for (int step = 0; step < 500 && !records.empty(); ++step) {
      if (random.unit() < 0.1) {
        const auto any =
            static_cast<std::size_t>(random.integer(0, static_cast<int>(records.size()) - 1));
        CHECK(spool.read_at(places[any]).value().bytes == records[any]);
      }
      const bool up = at == 0 || (at < records.size() && random.unit() < 0.6);
      const auto record = up ? spool.next() : spool.previous();
      REQUIRE(record.value().has_value());
      CHECK(record.value()->bytes == records[up ? at : at - 1]);
      at = up ? at + 1 : at - 1;
    }
  }
}

TEST_CASE("a folder that is not there is an error that names it and what to do") {
  const auto made = host::RecordSpool::create("/no/such/folder", kUse);
  REQUIRE_FALSE(made.ok());
  CHECK_NE(made.error().message.find("/no/such/folder"), std::string::npos);
  CHECK_NE(made.error().message.find("a test"), std::string::npos);
  CHECK_NE(made.error().message.find("do nothing"), std::string::npos);
}
