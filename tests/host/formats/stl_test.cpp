#include "host/formats/stl.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/mesh.h"
#include "tools/parts/part_maker.h"

using core::ErrorCode;
using core::Triangle;
using host::InputFile;
using host::StlReader;

namespace {

struct Outcome {
  std::string format;
  std::vector<Triangle> triangles;
  std::vector<std::string> warnings;
  std::string doubt;
  bool ok = false;
  ErrorCode code{};
  std::string message;
};

Outcome read(const std::string& bytes) {
  Outcome result;
  auto reader = StlReader::open(InputFile::from_bytes("part.stl", bytes));
  while (reader.ok()) {
    const auto triangle = reader.value()->next();
    if (!triangle.ok()) {
      result.code = triangle.error().code;
      result.message = triangle.error().message;
      return result;
    }
    if (!triangle.value()) {
      result.ok = true;
      result.format = reader.value()->format();
      result.warnings = reader.value()->warnings();
      result.doubt = reader.value()->doubt();
      CHECK_EQ(reader.value()->facets(), static_cast<std::int64_t>(result.triangles.size()));
      return result;
    }
    result.triangles.push_back(*triangle.value());
  }
  result.code = reader.error().code;
  result.message = reader.error().message;
  return result;
}

const parts::Part kBox = parts::box({0, 0, 0}, 20, 20, 10);

std::string binary_box() {
  std::ostringstream out;
  parts::write_binary_stl(kBox, out);
  return out.str();
}

std::string text_box() {
  std::ostringstream out;
  parts::write_ascii_stl(kBox, out);
  return out.str();
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::string with_count(std::string bytes, std::uint32_t count) {
  for (std::size_t i = 0; i < 4; ++i) bytes[80 + i] = static_cast<char>(count >> (8 * i) & 0xFF);
  return bytes;
}

void check_is_box(const Outcome& outcome) {
  CHECK_MESSAGE(outcome.ok, outcome.message);
  const std::vector<Triangle> expected = test::triangles_of(kBox);
  REQUIRE_EQ(outcome.triangles.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(outcome.triangles[i].corners == expected[i].corners);
  }
}

void check_refused(const Outcome& outcome, ErrorCode code, const std::vector<std::string>& parts) {
  REQUIRE_FALSE(outcome.ok);
  CHECK_EQ(outcome.code, code);
  CAPTURE(outcome.message);
  CHECK(outcome.message.starts_with("part.stl: "));
  for (const std::string& part : parts) {
    CAPTURE(part);
    CHECK(outcome.message.find(part) != std::string::npos);
  }
}

}  // namespace

TEST_CASE("both kinds, told apart by their content") {
  check_is_box(read(binary_box()));
  CHECK_EQ(read(binary_box()).format, "binary STL");
  CHECK(read(binary_box()).warnings.empty());
  check_is_box(read(text_box()));
  CHECK_EQ(read(text_box()).format, "ASCII STL");
}

TEST_CASE("binary files that begin with 'solid'") {
  for (const std::string header :
       {"solid", "solid but binary all the same", "solid a\nb", "SOLID \t facet normal 0 0 0"}) {
    std::string bytes = binary_box();
    std::fill_n(bytes.begin(), 80, ' ');
    std::copy(header.begin(), header.end(), bytes.begin());
    CAPTURE(header);
    check_is_box(read(bytes));
    CHECK_EQ(read(bytes).format, "binary STL");
  }
  std::string empty_header = binary_box();
  std::fill_n(empty_header.begin(), 80, '\0');
  check_is_box(read(empty_header));
}

TEST_CASE("text with every liberty that readers have met") {
  const std::string text = text_box();
  check_is_box(read(replaced(text, "\n", "\r\n")));
  check_is_box(read(replaced(text, "\n", "\r")));
  check_is_box(read(replaced(text, "\n", "\n\n")));
  check_is_box(read(replaced(text, " ", " \t ")));
  check_is_box(read("\n\t  " + text));
  check_is_box(read("\xEF\xBB\xBF" + text));
  check_is_box(read(text.substr(0, text.size() - 1)));
  check_is_box(read(replaced(text, "endsolid part\n", "endsolid")));
  check_is_box(read(replaced(text, "solid part", "solid")));
  check_is_box(read(replaced(text, "solid part", "solid of two words facet normal")));
  check_is_box(read(replaced(text, "solid part", "solid \xE6\x9C\x88 \xFF\xFE")));
  check_is_box(read(replaced(text, "solid part", "solid " + std::string(5'000, 'x'))));
  check_is_box(read(replaced(text, " 20", " +2.000000E+01")));
  check_is_box(read(replaced(text, " 20", " 200e-1")));
  check_is_box(read(replaced(text, "normal 0 0 -1", "normal nan nan -nan(ind)")));
  std::string upper = text;
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  check_is_box(read(upper));
  check_is_box(read(replaced(replaced(text, "facet", "Facet"), "outer", "OUTER")));
}

TEST_CASE("several solids in one file, some without facets") {
  const Outcome twice = read(text_box() + "solid\nendsolid\n" + text_box());
  CHECK(twice.ok);
  CHECK_EQ(twice.triangles.size(), 24);
}

TEST_CASE("a count in the header that does not fit the file") {
  for (const std::uint32_t count : {13U, 1'000'000U, 0x7FFFFFFFU, 0xFFFFFFFFU, 0U}) {
    CAPTURE(count);
    const Outcome outcome = read(with_count(binary_box(), count));
    check_is_box(outcome);
    // More than are there may be a file that was cut off; such numbers are none.
    const bool no_count = count == 0 || count > 0x7FFFFFFE;
    REQUIRE_EQ(outcome.warnings.size(), no_count ? 1 : 0);
    const std::string& said = no_count ? outcome.warnings[0] : outcome.doubt;
    CHECK(said.find(std::to_string(count)) != std::string::npos);
  }
  // Fewer than fill the file: those that fill it count. With bytes behind that are no facets, the
  // head does.
  const Outcome fewer = read(with_count(binary_box(), 5));
  check_is_box(fewer);
  REQUIRE_EQ(fewer.warnings.size(), 1);
  CHECK(fewer.warnings[0].find("counts 5 facets, the file has 12") != std::string::npos);
  const Outcome behind = read(with_count(binary_box() + "xyz", 5));
  CHECK(behind.ok);
  CHECK_EQ(behind.triangles.size(), 5);
  REQUIRE_EQ(behind.warnings.size(), 1);
  CHECK(behind.warnings[0].find("byte 334") != std::string::npos);
}

TEST_CASE("a file as long as its count says is binary, whatever its head looks like") {
  std::string bytes = binary_box();
  const std::string header = "solid part\n facet normal 0 0 1\n  outer loop\n";
  std::copy(header.begin(), header.end(), bytes.begin());
  check_is_box(read(bytes));
  CHECK_EQ(read(bytes).format, "binary STL");
}

TEST_CASE("colour bytes after a facet do not matter") {
  std::string bytes = binary_box();
  for (std::size_t i = 84 + 48; i < bytes.size(); i += 50) bytes[i] = '\x7F';
  check_is_box(read(bytes));
}

TEST_CASE("files that are no STL, or hold nothing") {
  check_refused(read(""), ErrorCode::kBadPart, {"empty"});
  check_refused(read(binary_box().substr(0, 84)), ErrorCode::kBadPart, {"no facet"});
  check_refused(read(with_count(binary_box().substr(0, 84), 0)), ErrorCode::kBadPart,
                {"byte 84", "no facet"});
  check_refused(read("solid nothing\nendsolid nothing\n"), ErrorCode::kBadPart,
                {"line 3", "no facet"});
  check_refused(read("Dear reader,\nthis is no part.\n"), ErrorCode::kBadPart,
                {"line 1", "of no kind that is known"});
  check_refused(read("solid ground\nis what we stand upon"), ErrorCode::kBadPart,
                {"line 2", "'facet'"});
  check_refused(read("PK\x03\x04 and so on"), ErrorCode::kBadPart, {"zip", "STL"});
  check_refused(read(std::string("\x00\x01\x02", 3)), ErrorCode::kBadPart, {"byte 3", "84"});
}

TEST_CASE("what is wrong in a text is said with its line") {
  const std::string text = text_box();
  // The second facet begins in line 9.
  const auto broken = [&text](const std::string& what, const std::string& by) {
    std::string changed = text;
    const std::size_t at = changed.find(what, changed.find("endfacet"));
    return read(changed.replace(at, what.size(), by));
  };
  check_refused(broken("vertex 0 0 0", "vertex 0 zero 0"), ErrorCode::kBadPart,
                {"facet 2", "line 11", "'zero'", "a number"});
  check_refused(broken("vertex 0 0 0", "vertex 0 1,5 0"), ErrorCode::kBadPart, {"'1,5'"});
  check_refused(broken("vertex 0 0 0", "vertex 0 0x10 0"), ErrorCode::kBadPart, {"'0x10'"});
  check_refused(broken("vertex 0 0 0", "vertex 0 + 0"), ErrorCode::kBadPart, {"'+'"});
  check_refused(broken("vertex 0 0 0", "vertex 0 0"), ErrorCode::kBadPart, {"'vertex'"});
  check_refused(broken("vertex 0 0 0", ""), ErrorCode::kBadPart,
                {"facet 2", "'endloop' where 'vertex'"});
  check_refused(broken("outer loop", "outer rim"), ErrorCode::kBadPart, {"'rim'", "'loop'"});
  check_refused(broken("endfacet\n", "\x01\n"), ErrorCode::kBadPart, {"'?'"});
  check_refused(broken("endfacet\n", std::string(1'000'000, 'x')), ErrorCode::kBadPart, {"'xxx"});
}

TEST_CASE("lines are counted alike, whatever ends them") {
  std::string text = text_box();
  text.replace(text.rfind("vertex"), 6, "corner");
  for (const std::string end : {"\n", "\r", "\r\n"}) {
    check_refused(read(replaced(text, "\n", end)), ErrorCode::kBadPart, {"facet 12 (line 83)"});
  }
}

TEST_CASE("coordinates that are no place: the facet is named") {
  for (const std::string value : {"nan", "inf", "-infinity", "1e999"}) {
    CAPTURE(value);
    std::string text = text_box();
    text.replace(text.rfind("vertex 0"), 8, "vertex " + value);
    check_refused(read(text), ErrorCode::kBadPart, {"facet 12", "finite"});
  }
  std::string bytes = binary_box();
  for (const std::size_t byte : {std::size_t{2}, std::size_t{3}}) {
    bytes[84 + 50 * 3 + 12 + byte] = static_cast<char>(byte == 2 ? 0x80 : 0x7F);
  }
  check_refused(read(bytes), ErrorCode::kBadPart, {"facet 4", "byte 234", "finite"});
}

TEST_CASE("far away") {
  const auto at = [](double x, double y, double z) {
    std::ostringstream out;
    parts::write_binary_stl(parts::box({x, y, z}, 20, 20, 10), out);
    return read(out.str());
  };
  check_refused(at(1e7, 1e7, 1e7), ErrorCode::kOutOfBounds, {"facet 1", "10000000", "53687"});
  check_refused(at(0, -6e4, 0), ErrorCode::kOutOfBounds, {"-60000"});
  check_refused(at(0, 0, 3e11), ErrorCode::kOutOfBounds, {"100000000000"});
  CHECK(at(-5e4, 5e4, 1e9).ok);
}

TEST_CASE("cut at every byte: an error, or a doubt where whole facets are left") {
  const std::string bytes = binary_box();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const Outcome outcome = read(bytes.substr(0, size));
    const bool whole = size > 84 && (size - 84) % 50 == 0;
    CAPTURE(size);
    CHECK_EQ(outcome.ok, whole);
    CHECK_EQ(!outcome.doubt.empty(), whole);
    CHECK(outcome.warnings.empty());
  }
  const std::string text = text_box();
  const std::size_t complete = text.rfind("endsolid") + 8;
  for (std::size_t size = 0; size < text.size(); ++size) {
    CAPTURE(size);
    const Outcome outcome = read(text.substr(0, size));
    // Behind a facet, before the next word.
    const std::size_t facet = text.rfind("endfacet", size);
    const bool between = facet != std::string::npos && size >= facet + 8 &&
                         text.find_first_not_of(" \n", facet + 8) >= size;
    CHECK_EQ(outcome.ok, size >= complete || between);
    CHECK_EQ(!outcome.doubt.empty(), between && size < complete);
    if (!outcome.ok) CHECK_EQ(outcome.code, ErrorCode::kBadPart);
  }
}

TEST_CASE("any byte changed: read or refused, never more") {
  test::Random random(11);
  for (const std::string& file : {binary_box(), text_box()}) {
    for (std::size_t i = 0; i < file.size(); ++i) {
      CAPTURE(i);
      std::string changed = file;
      changed[i] = static_cast<char>(random.integer(0, 255));
      const Outcome outcome = read(changed);
      CHECK((outcome.ok || !outcome.message.empty()));
    }
  }
}
