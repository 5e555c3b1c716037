// Painted facets, held against a second reading of their text that asks for one point at a time.
#include "host/formats/facet_paint.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/random_regions.h"

using core::Triangle;
using host::FacetPaint;

namespace {

// A triangle in the plane z = 0.
Triangle flat_triangle(std::array<std::pair<double, double>, 3> mm) {
  Triangle triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    triangle.corners[i] = {static_cast<std::int32_t>(mm[i].first * 10'000),
                           static_cast<std::int32_t>(mm[i].second * 10'000), 0};
  }
  return triangle;
}

Triangle right_triangle() { return flat_triangle({{{0, 0}, {16, 0}, {0, 16}}}); }

using Pieces = std::vector<std::pair<Triangle, FacetPaint>>;

Pieces pieces_of(const std::string& text, const Triangle& triangle = right_triangle()) {
  REQUIRE(host::is_paint(text));
  Pieces pieces;
  const core::Status done = host::each_painted_piece(
      text, triangle, [&](const Triangle& piece, FacetPaint paint) -> core::Status {
        pieces.emplace_back(piece, paint);
        return {};
      });
  REQUIRE(done.ok());
  return pieces;
}

double area_mm2(const Triangle& t) {
  const auto& [a, b, c] = t.corners;
  return std::abs(static_cast<double>(core::cross({a.x, a.y}, {b.x, b.y}, {c.x, c.y}))) / 2 / 1e8;
}

bool contains(const Triangle& t, core::Point at) {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const core::Vertex &a = t.corners[i], &b = t.corners[(i + 1) % 3];
    const std::int64_t side = core::cross({a.x, a.y}, {b.x, b.y}, at);
    left += side > 0 ? 1 : 0;
    right += side < 0 ? 1 : 0;
  }
  return left == 3 || right == 3;
}

// A random tree, by its definition: a piece's children last first, the text's last digit first.
void append_tree(test::Random& random, int depth, std::string& digits) {
  const auto digit = [&digits](int value) { digits += "0123456789ABCDEF"[value]; };
  const int halved = depth == 0 ? 0 : random.integer(0, 3);
  if (halved == 0) {
    const int mark = random.integer(0, 3);
    digit(mark * 4);
    if (mark == 3) digit(random.integer(0, 15));
    return;
  }
  digit(halved + 4 * (halved == 3 ? 0 : random.integer(0, 2)));
  for (int child = 0; child <= halved; ++child) append_tree(random, depth - 1, digits);
}

std::string reversed(const std::string& text) { return {text.rbegin(), text.rend()}; }

// A point by its shares of the facet's corners.
using Shares = std::array<double, 3>;

// What is painted at a point of the facet, by walking down the tree in the coordinates of each
// piece. `digits` is read from its beginning; -1: the tree goes on, but not under the point.
class PointReader {
 public:
  explicit PointReader(std::string digits) : digits_(std::move(digits)) {}

  int mark_at(const Shares& shares) {
    at_ = 0;
    return read(&shares);
  }

 private:
  int next() {
    const char c = digits_[at_++];
    return c <= '9' ? c - '0' : c - 'A' + 10;
  }

  // nullptr: the point is not in this piece.
  int read(const Shares* shares) {
    const int digit = next(), halved = digit % 4, first = digit / 4;
    if (halved == 0) {
      int mark = first;
      if (mark == 3) mark += next();
      return shares != nullptr ? mark : -1;
    }
    std::vector<const Shares*> wanted(static_cast<std::size_t>(halved) + 1, nullptr);
    Shares inner{};
    if (shares != nullptr) {
      const double a = (*shares)[static_cast<std::size_t>(first % 3)];
      const double b = (*shares)[static_cast<std::size_t>((first + 1) % 3)];
      const double c = (*shares)[static_cast<std::size_t>((first + 2) % 3)];
      wanted[child_at(halved, a, b, c, inner)] = &inner;
    }
    int found = -1;
    for (std::size_t child = wanted.size(); child-- > 0;) {
      const int mark = read(wanted[child]);
      if (mark >= 0) found = mark;
    }
    return found;
  }

  // The child that has the point, and its shares there.
  static std::size_t child_at(int halved, double a, double b, double c, Shares& inner) {
    const auto in = [&inner](std::size_t child, Shares shares) {
      inner = shares;
      return child;
    };
    if (halved == 1) {
      return b >= c ? in(0, {a, b - c, 2 * c}) : in(1, {2 * b, c - b, a});
    }
    if (halved == 2) {
      if (a >= 0.5) return in(0, {2 * a - 1, 2 * b, 2 * c});
      return c >= a ? in(2, {b, c - a, 2 * a}) : in(1, {2 * a - 2 * c, b - a + c, 2 * c});
    }
    if (a >= 0.5) return in(0, {2 * a - 1, 2 * b, 2 * c});
    if (b >= 0.5) return in(1, {2 * a, 2 * b - 1, 2 * c});
    if (c >= 0.5) return in(2, {2 * b, 2 * c - 1, 2 * a});
    return in(3, {1 - 2 * c, 1 - 2 * a, 1 - 2 * b});
  }

  std::string digits_;
  std::size_t at_ = 0;
};

}  // namespace

TEST_CASE("whole facets and single splits, as PrusaSlicer writes them") {
  CHECK(pieces_of("0").empty());
  const Pieces whole = pieces_of("4");
  REQUIRE_EQ(whole.size(), 1);
  CHECK(whole.front().second == FacetPaint::kEnforcer);
  CHECK(whole.front().first.corners == right_triangle().corners);
  CHECK(pieces_of("8").front().second == FacetPaint::kBlocker);
  CHECK(pieces_of("2C").front().second == FacetPaint::kUnknown);

  // One edge is halved, that across from corner 0; the half at corner 2 is an enforcer. The text's
  // last digit is the root, the one before it the last child.
  const Pieces half = pieces_of("041");
  REQUIRE_EQ(half.size(), 1);
  CHECK(contains(half.front().first, {20'000, 100'000}));
  CHECK_EQ(area_mm2(half.front().first), doctest::Approx(64));
  // The same about corner 1: the halved edge goes from corner 2 to corner 0.
  CHECK(contains(pieces_of("045").front().first, {20'000, 20'000}));
  // Two edges halved, those at corner 0; its own piece is a blocker.
  const Pieces corner = pieces_of("8002");
  REQUIRE_EQ(corner.size(), 1);
  CHECK(corner.front().second == FacetPaint::kBlocker);
  CHECK(contains(corner.front().first, {20'000, 20'000}));
  CHECK_EQ(area_mm2(corner.front().first), doctest::Approx(32));
  // All three halved; the middle is an enforcer.
  const Pieces middle = pieces_of("00043");
  REQUIRE_EQ(middle.size(), 1);
  CHECK(contains(middle.front().first, {53'000, 53'000}));
  CHECK_FALSE(contains(middle.front().first, {20'000, 20'000}));
}

TEST_CASE("any tree marks the points that its text says, and pieces do not overlap") {
  int marked = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::string digits;
    append_tree(random, 5, digits);
    const Triangle facet = flat_triangle({{{random.between(0, 5), random.between(0, 5)},
                                           {random.between(60, 90), random.between(0, 20)},
                                           {random.between(0, 40), random.between(60, 90)}}});
    const Pieces pieces = pieces_of(reversed(digits), facet);
    PointReader reader(digits);
    for (int i = 0; i < 60; ++i) {
      const double p = random.unit(), q = random.unit();
      const Shares shares = {1 - std::max(p, q), std::max(p, q) - std::min(p, q), std::min(p, q)};
      double x = 0, y = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        x += shares[k] * facet.corners[k].x;
        y += shares[k] * facet.corners[k].y;
      }
      const core::Point at{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
      const int expected = std::min(reader.mark_at(shares), 3);
      int found = 0, count = 0;
      for (const auto& [piece, paint] : pieces) {
        if (!contains(piece, at)) continue;
        found = static_cast<int>(paint);
        ++count;
      }
      CHECK_LE(count, 1);
      CHECK_EQ(found, expected);
      marked += found > 0 ? 1 : 0;
    }
  }
  CHECK_GT(marked, 1'000);
}

TEST_CASE("neighbours that are split alike have the same points between them") {
  const Triangle one = flat_triangle({{{0, 0}, {7.7773, 3.3331}, {0, 9}}});
  const Triangle other = flat_triangle({{{7.7773, 3.3331}, {0, 0}, {9, -5}}});
  // A split about corner 2 halves the edge from 0 to 1; both halves once more.
  const auto corners_of = [](const Triangle& triangle) {
    std::vector<core::Vertex> corners;
    for (const auto& [piece, paint] : pieces_of("44443444439", triangle)) {
      corners.insert(corners.end(), piece.corners.begin(), piece.corners.end());
    }
    return corners;
  };
  const std::vector<core::Vertex> here = corners_of(one), there = corners_of(other);
  int shared = 0;
  for (const core::Vertex& corner : here) {
    shared += std::find(there.begin(), there.end(), corner) != there.end() ? 1 : 0;
  }
  CHECK_GE(shared, 5);
}

TEST_CASE("what is no whole tree is refused, at every cut and with every digit changed") {
  CHECK_FALSE(host::is_paint(""));
  for (const std::string text : {"G", "4 ", "C", "41", "0443", "00000", "44", "E", "D00", "0x4"}) {
    CAPTURE(text);
    CHECK_FALSE(host::is_paint(text));
  }
  CHECK(host::is_paint("041"));
  CHECK(host::is_paint("0004f"));  // the corner of three halved edges has no meaning
  test::Random random(9);
  std::string digits;
  while (digits.size() < 40) {
    digits.clear();
    append_tree(random, 6, digits);
  }
  const std::string text = reversed(digits);
  CHECK(host::is_paint(text));
  for (std::size_t cut = 1; cut <= text.size(); ++cut) {
    CHECK_FALSE(host::is_paint(text.substr(cut)));
    CHECK_FALSE(host::is_paint(std::string(cut, '0') + text));
  }
  // Deeper than it may be.
  std::string deep = "0";
  for (int i = 0; i < host::kPaintDepthMax; ++i) deep = "0" + deep + "1";
  CHECK(host::is_paint(deep));
  CHECK_FALSE(host::is_paint("0" + deep + "1"));
}
