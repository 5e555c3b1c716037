// CLI as it is found in the wild.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/support/format_samples.h"
#include "tests/support/region_text.h"

using core::Slice;
using test::error_of;
using test::read_bytes;
using test::region_from_text;

namespace {

const std::string kHead = "$$HEADERSTART\n$$ASCII\n$$UNITS/1\n$$HEADEREND\n$$GEOMETRYSTART\n";
const std::string kSquare = "$$POLYLINE/1,1,5,0,0,4,0,4,4,0,4,0,0\n";

std::vector<Slice> slices_of(const std::string& bytes) {
  const auto read = read_bytes(bytes);
  REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : read.error().message));
  return read.value().slices;
}

std::string binary_head(const std::string& extra) {
  return "$$HEADERSTART\n$$BINARY\n$$UNITS/0.01\n" + extra + "$$HEADEREND";
}

bool says(const std::string& message, const std::string& text) {
  CAPTURE(message);
  return message.find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("the plate with a hole: units, comments, labels, user data, hatches, unknown words") {
  const auto read = read_bytes(test::format_sample("ascii.cli"));
  REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : read.error().message));
  CHECK_EQ(read.value().format, "ASCII CLI");
  const std::vector<Slice>& slices = read.value().slices;
  REQUIRE_EQ(slices.size(), 2);
  CHECK_EQ(slices[0].region, region_from_text("0:0 10:0 10:10 0:10, 4:4 4:6 6:6 6:4"));
  CHECK_EQ(slices[0].bottom.mm(), 0);
  CHECK_EQ(slices[0].height.mm(), 0.2);
  CHECK_EQ(slices[1].region, region_from_text("0:0 9:0 0:9"));
  CHECK_EQ(slices[1].bottom.mm(), 0.2);
  CHECK_EQ(read.value().warnings.size(), 2);  // hatches, an open line
}

TEST_CASE("the direction counts more than the order of the points") {
  const std::vector<Slice> slices =
      slices_of(kHead + "$$LAYER/0\n$$LAYER/0.2\n$$POLYLINE/1,1,5,0,0,0,9,9,9,9,0,0,0\n" +
                "$$POLYLINE/1,0,5,2,2,4,2,4,4,2,4,2,2\n$$GEOMETRYEND\n");
  REQUIRE_EQ(slices.size(), 1);
  CHECK_EQ(slices[0].region, region_from_text("0:0 9:0 9:9 0:9, 2:2 2:4 4:4 4:2"));
}

TEST_CASE("where the first layer stands") {
  const auto bottom_of = [](const std::string& layers) {
    const std::vector<Slice> slices = slices_of(kHead + layers + "$$GEOMETRYEND\n");
    REQUIRE_FALSE(slices.empty());
    return slices[0].bottom.mm();
  };
  // An empty one below it, at 0 or on supports.
  CHECK_EQ(bottom_of("$$LAYER/0\n$$LAYER/0.3\n" + kSquare), 0);
  CHECK_EQ(bottom_of("$$LAYER/3.99\n$$LAYER/4.29\n" + kSquare), 3.99);
  // None: on 0, also when it is thicker; else as thick as the next.
  CHECK_EQ(bottom_of("$$LAYER/0.3\n" + kSquare + "$$LAYER/0.5\n" + kSquare), 0);
  CHECK_EQ(bottom_of("$$LAYER/4\n" + kSquare + "$$LAYER/4.2\n" + kSquare), 3.8);
  CHECK_EQ(bottom_of("$$LAYER/0\n" + kSquare + "$$LAYER/0.2\n" + kSquare), -0.2);
  CHECK_EQ(bottom_of("$$LAYER/0.3\n" + kSquare), 0);
}

TEST_CASE("heights vary; one height said twice is one layer; parts are united") {
  const std::vector<Slice> slices = slices_of(
      kHead + "$$LAYER/0\n$$LAYER/0.2\n" + kSquare + "$$LAYER/0.2\n" +
      "$$POLYLINE/2,1,5,2,0,6,0,6,4,2,4,2,0\n$$LAYER/0.5\n" + kSquare + "$$GEOMETRYEND\n");
  REQUIRE_EQ(slices.size(), 2);
  CHECK_EQ(slices[0].region, region_from_text("0:0 6:0 6:4 0:4"));
  CHECK_EQ(slices[1].height.mm(), doctest::Approx(0.3));
}

TEST_CASE("coordinates left of the origin are signed, if the head says that there are any") {
  const auto file = [](const std::string& dimension) {
    std::string bytes = binary_head(dimension);
    for (const unsigned number : {128U, 20U, 129U, 1U, 1U, 4U, 65'536U - 500U, 0U, 500U, 0U, 0U,
                                  500U, 65'536U - 500U, 0U}) {
      test::append_u16(number, bytes);
    }
    return bytes;
  };
  CHECK_EQ(slices_of(file("$$DIMENSION/-5.0,0,0,5,5,1\n"))[0].region,
           region_from_text("-5:0 5:0 0:5"));
  CHECK_EQ(slices_of(file(""))[0].region, region_from_text("0:5 5:0 650.36:0"));
}

TEST_CASE("heights take all 16 bits, unless the head says that they begin below 0") {
  const auto file = [](const std::string& dimension, unsigned z) {
    std::string bytes = binary_head(dimension);
    for (const unsigned number : {128U,
                                  z,
                                  129U,
                                  1U,
                                  1U,
                                  4U,
                                  65'536U - 500U,
                                  0U,
                                  500U,
                                  0U,
                                  0U,
                                  500U,
                                  65'536U - 500U,
                                  0U,
                                  128U,
                                  z + 20U,
                                  129U,
                                  1U,
                                  1U,
                                  4U,
                                  65'536U - 500U,
                                  0U,
                                  500U,
                                  0U,
                                  0U,
                                  500U,
                                  65'536U - 500U,
                                  0U}) {
      test::append_u16(number, bytes);
    }
    return bytes;
  };
  const std::vector<Slice> high = slices_of(file("$$DIMENSION/-5.0,0,0,5,5,500\n", 40'000));
  REQUIRE_EQ(high.size(), 2);
  CHECK_EQ(high[1].top().mm(), doctest::Approx(400.2));
  CHECK_EQ(high[1].region, region_from_text("-5:0 5:0 0:5"));
  const std::vector<Slice> low = slices_of(file("$$DIMENSION/-5.0,0,-5,5,5,0\n", 65'536U - 400U));
  CHECK_EQ(low[1].top().mm(), doctest::Approx(-3.8));
}

TEST_CASE("aligned binary files") {
  std::string bytes = binary_head("$$ALIGN\n");
  test::append_u32(128, bytes);
  test::append_u32(20, bytes);
  test::append_u32(129, bytes);
  for (const unsigned number : {1U, 1U, 4U}) test::append_u32(number, bytes);
  for (const unsigned number : {0U, 0U, 500U, 0U, 0U, 500U, 0U, 0U}) {
    test::append_u16(number, bytes);
  }
  CHECK_EQ(slices_of(bytes)[0].region, region_from_text("0:0 5:0 0:5"));
}

TEST_CASE("what is wrong, and where") {
  const std::string layer = "$$LAYER/0\n$$LAYER/0.2\n";
  CHECK(says(error_of("$$HEADERSTART\n$$ASCII\n$$HEADEREND\n"), "line 3: the head has no $$UNITS"));
  CHECK(says(error_of("$$HEADERSTART\n$$UNITS/1\n$$HEADEREND\n"), "neither $$ASCII nor"));
  CHECK(says(error_of("$$HEADERSTART\n$$UNITS/-1\n"), "line 2: $$UNITS/-1 is no unit"));
  CHECK(says(error_of(kHead + layer + "$$POLYLINE/1,1,2,0,x,4,4\n"), "line 8: 'x' where a coord"));
  CHECK(says(error_of(kHead + layer + "$$POLYLINE/1,7,2,0,0,4,4\n"), "direction is 7"));
  CHECK(says(error_of(kHead + layer + "$$POLYLINE/1,1,-2,0,0\n"), "-2 is no number of points"));
  CHECK(says(error_of(kHead + layer + "$$POLYLINE/1,1,99999999,0,0\n"), "99999999 is no number"));
  CHECK(says(error_of(kHead + layer + "$$POLYLINE/1,1,1,1e9,0\n"), "farther than 53687 mm"));
  CHECK(
      says(error_of(kHead + layer + kSquare + "$$LAYER/0.1\n$$GEOMETRYEND\n"), "0.1 mm does not"));
  CHECK(says(error_of(kHead + kSquare), "before the first layer"));
  CHECK(says(error_of(kHead + layer + kSquare), "line 9: the file ends where '$$GEOMETRYEND'"));
  CHECK(says(error_of(binary_head("") + "zz"), ": command 31354 is none"));
}
