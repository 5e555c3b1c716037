#include "host/output/part_view.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>
#include <string>
#include <vector>

#include "tests/support/mesh.h"
#include "tests/support/random_regions.h"
#include "tools/parts/part_maker.h"

using core::Triangle;
using core::Vertex;
using host::PartView;
using host::RgbaPicture;

namespace {
std::size_t allocations = 0;
}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  void* memory = std::malloc(std::max<std::size_t>(size, 1));
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }

namespace {

using Point = std::array<double, 3>;

constexpr Point kToViewer = {-1, -1, 1}, kRight = {1, -1, 0}, kUp = {0.5, 0.5, 1};

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Point place(const Vertex& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

Point on_screen(const Point& p) {
  return {dot(p, kRight) / std::sqrt(dot(kRight, kRight)), dot(p, kUp) / std::sqrt(dot(kUp, kUp)),
          dot(p, kToViewer)};
}

// Light from above and a little from the front and the left; the formula of the colours.
double brightness(const std::array<Point, 3>& corners) {
  Point normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
  if (dot(normal, kToViewer) < 0) normal = {-normal[0], -normal[1], -normal[2]};
  const Point light = {-0.2545, -0.5937, 0.7634};
  return 0.2 + 0.8 * std::max(0.0, dot(normal, light) / std::sqrt(dot(normal, normal)));
}

// The part drawn when it is known how large it is: at kSamples² places in each pixel, the
// brightness of the nearest facet, or none.
class Raster {
 public:
  static constexpr int kSamples = 3;

  Raster(const std::vector<Triangle>& triangles, int width, int height)
      : columns_(width * kSamples),
        rows_(height * kSamples),
        bright_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kNone),
        near_(bright_.size(), -std::numeric_limits<double>::infinity()) {
    Point low{1e18, 1e18, 0}, high{-1e18, -1e18, 0};
    for (const Triangle& t : triangles) {
      for (const Vertex& corner : t.corners) {
        const Point p = on_screen(place(corner));
        for (std::size_t i = 0; i < 2; ++i) {
          low[i] = std::min(low[i], p[i]);
          high[i] = std::max(high[i], p[i]);
        }
      }
    }
    const double margin = std::min(width, height) / 32.0;
    const double pixel = std::max((high[0] - low[0]) / (width - 2 * margin),
                                  (high[1] - low[1]) / (height - 2 * margin));
    step_ = pixel / kSamples;
    left_ = (low[0] + high[0] - pixel * width) / 2;
    top_ = (low[1] + high[1] + pixel * height) / 2;
    for (const Triangle& t : triangles) draw(t);
  }

  // The lowest and highest of the samples on a pixel and one pixel around it; kNone is nothing.
  struct Range {
    double darkest = 2, brightest = -1;
    bool all = true, any = false;
  };
  [[nodiscard]] Range around(int x, int y) const {
    Range range;
    for (int row = (y - 1) * kSamples; row < (y + 2) * kSamples; ++row) {
      for (int column = (x - 1) * kSamples; column < (x + 2) * kSamples; ++column) {
        const bool within = row >= 0 && column >= 0 && row < rows_ && column < columns_;
        const double bright = within ? bright_[at(column, row)] : kNone;
        if (bright == kNone) {
          range.all = false;
          continue;
        }
        range.any = true;
        range.darkest = std::min(range.darkest, bright);
        range.brightest = std::max(range.brightest, bright);
      }
    }
    return range;
  }

 private:
  static constexpr double kNone = -1;

  [[nodiscard]] std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  void draw(const Triangle& triangle) {
    const std::array<Point, 3> corners = {place(triangle.corners[0]), place(triangle.corners[1]),
                                          place(triangle.corners[2])};
    std::array<Point, 3> seen;
    std::transform(corners.begin(), corners.end(), seen.begin(), on_screen);
    const auto [a, b, c] = seen;
    const auto turn = [](const Point& p, const Point& q, double x, double y) {
      return (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
    };
    const double area = turn(a, b, c[0], c[1]);
    if (area == 0) return;
    const double bright = brightness(corners);
    const auto [left, right] = std::minmax({a[0], b[0], c[0]});
    const auto [low, high] = std::minmax({a[1], b[1], c[1]});
    for (int row = std::max(0, static_cast<int>((top_ - high) / step_) - 1);
         row < rows_ && row <= (top_ - low) / step_; ++row) {
      for (int column = std::max(0, static_cast<int>((left - left_) / step_) - 1);
           column < columns_ && column <= (right - left_) / step_; ++column) {
        const double x = left_ + (column + 0.5) * step_, y = top_ - (row + 0.5) * step_;
        const double of_a = turn(b, c, x, y) / area, of_b = turn(c, a, x, y) / area;
        const double of_c = turn(a, b, x, y) / area;
        if (of_a < 0 || of_b < 0 || of_c < 0) continue;
        const double near = of_a * a[2] + of_b * b[2] + of_c * c[2];
        if (near <= near_[at(column, row)]) continue;
        near_[at(column, row)] = near;
        bright_[at(column, row)] = bright;
      }
    }
  }

  int columns_, rows_;
  double step_ = 1, left_ = 0, top_ = 0;
  std::vector<double> bright_, near_;
};

PartView seen(const std::vector<Triangle>& triangles) {
  PartView view;
  for (const Triangle& t : triangles) view.add(t);
  return view;
}

// Between the darkest and the brightest colour, as far as it is bright; each channel.
bool shows(const std::uint8_t* pixel, double darkest, double brightest) {
  constexpr std::array<double, 3> kDark = {0x5a, 0x33, 0x10}, kBright = {0xff, 0xdc, 0x9c};
  constexpr double kRounding = 1.5;
  for (std::size_t i = 0; i < 3; ++i) {
    const double range = kBright[i] - kDark[i];
    if (pixel[i] < kDark[i] + darkest * range - kRounding) return false;
    if (pixel[i] > kDark[i] + brightest * range + kRounding) return false;
  }
  return true;
}

// How many pixels show what the raster has nowhere near them.
int wrong_pixels(const RgbaPicture& picture, const Raster& raster) {
  int wrong = 0;
  const std::uint8_t* pixel = picture.bytes.data();
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x, pixel += 4) {
      const Raster::Range range = raster.around(x, y);
      const bool right = (range.any || pixel[3] == 0) && (!range.all || pixel[3] == 255) &&
                         (pixel[3] == 0 || shows(pixel, range.darkest, range.brightest));
      if (!right) ++wrong;
    }
  }
  return wrong;
}

// Along outlines, a cell may show a facet that the raster's samples miss. In small pictures, more
// of the pixels are outline.
int wrong_pixels_max(int width, int height) {
  return std::max(width * height / 250, 2 * std::min(width, height));
}

std::vector<Triangle> moved(std::vector<Triangle> triangles, Vertex by, int times) {
  for (Triangle& t : triangles) {
    for (Vertex& v : t.corners) v = {v.x * times + by.x, v.y * times + by.y, v.z * times + by.z};
  }
  return triangles;
}

std::vector<std::vector<Triangle>> some_parts() {
  std::vector<std::vector<Triangle>> all;
  for (const parts::Part& part :
       {parts::demo(), parts::box({0, 0, 0}, 20, 20, 10), parts::sphere(12), parts::tee(),
        parts::tube(10, 6, 20, 64), parts::arch(24), parts::vase(0.05)}) {
    all.push_back(test::triangles_of(part));
  }
  return all;
}

}  // namespace

TEST_CASE("the picture is the one that is drawn when the part's size is known") {
  for (const std::vector<Triangle>& part : some_parts()) {
    struct Case {
      const char* name;
      std::vector<Triangle> triangles;
    };
    for (const Case& placed :
         {Case{"as it is", part}, Case{"moved", moved(part, {-3, 70'001, -5}, 1)},
          Case{"40 m away", moved(part, {400'000'003, -390'000'001, 12}, 1)},
          Case{"large", moved(part, {0, 0, 0}, 50)}}) {
      const std::string name = placed.name;
      CAPTURE(name);
      CAPTURE(placed.triangles.size());
      const PartView view = seen(placed.triangles);
      for (const auto& size : {std::array{300, 300}, {220, 124}, {32, 32}, {16, 90}}) {
        CAPTURE(size[0]);
        const int wrong = wrong_pixels(view.picture(size[0], size[1]),
                                       Raster(placed.triangles, size[0], size[1]));
        CHECK_LE(wrong, wrong_pixels_max(size[0], size[1]));
      }
    }
  }
}

TEST_CASE("the order of the facets does not matter") {
  constexpr unsigned kSeed = 23;
  CAPTURE(kSeed);
  test::Random random(kSeed);
  for (std::vector<Triangle> triangles : some_parts()) {
    const Raster raster(triangles, 300, 300);
    for (int i = 0; i < 3; ++i) {
      test::shuffle(triangles, random);
      CHECK_LE(wrong_pixels(seen(triangles).picture(300, 300), raster), wrong_pixels_max(300, 300));
    }
  }
}

TEST_CASE("both sides of a facet look the same") {
  std::vector<Triangle> triangles = test::triangles_of(parts::demo());
  const RgbaPicture before = seen(triangles).picture(300, 300);
  for (Triangle& t : triangles) std::swap(t.corners[0], t.corners[1]);
  CHECK(seen(triangles).picture(300, 300).bytes == before.bytes);
}

TEST_CASE("the sides of a box differ, and the background is transparent") {
  const RgbaPicture picture =
      seen(test::triangles_of(parts::box({0, 0, 0}, 10, 10, 10))).picture(100, 100);
  const auto red = [&](int x, int y) {
    return picture.bytes[std::size_t{400} * static_cast<std::size_t>(y) +
                         std::size_t{4} * static_cast<std::size_t>(x)];
  };
  const auto opacity = [&](int x, int y) {
    return picture.bytes[std::size_t{400} * static_cast<std::size_t>(y) +
                         std::size_t{4} * static_cast<std::size_t>(x) + 3];
  };
  CHECK_GT(red(50, 25), red(70, 60));  // top, front
  CHECK_GT(red(70, 60), red(30, 60));  // front, left
  CHECK_EQ(opacity(50, 50), 255);
  for (const int corner : {0, 99}) {
    CHECK_EQ(opacity(corner, 0), 0);
    CHECK_EQ(opacity(corner, 99), 0);
  }
}

TEST_CASE("what is narrower than a cell is a line without gaps") {
  // 100 mm long, 1 µm wide, in all directions of the plane of the screen.
  for (int degrees = 0; degrees < 180; degrees += 3) {
    CAPTURE(degrees);
    const double angle = degrees * std::acos(-1.0) / 180;
    const double across = std::cos(angle) * 1e6, up = std::sin(angle) * 1e6;
    const auto corner = [](double a, double b) {
      const double right = a / std::sqrt(2.0), back = b / std::sqrt(6.0);
      return Vertex{static_cast<std::int32_t>(right + back),
                    static_cast<std::int32_t>(back - right), static_cast<std::int64_t>(2 * back)};
    };
    const double aside = -10 * std::sin(angle), over = 10 * std::cos(angle);
    const Triangle needle{{corner(0, 0), corner(across, up), corner(across + aside, up + over)}};
    PartView view;
    view.add(needle);
    const RgbaPicture picture = view.picture(100, 100);
    int lines = 0;
    const bool flat = std::abs(across) > std::abs(up);
    for (std::size_t i = 0; i < 100; ++i) {
      bool any = false;
      for (std::size_t k = 0; k < 100; ++k) {
        any = any || picture.bytes[4 * (flat ? k * 100 + i : i * 100 + k) + 3] > 0;
      }
      if (any) ++lines;
    }
    CHECK_GE(lines, 93);
    CHECK_LE(lines, 96);
  }
}

TEST_CASE("of cells that become one, the nearest stays") {
  PartView view;
  const auto add = [&](Vertex a, Vertex b, Vertex c, Vertex d) {
    view.add({{a, b, c}});
    view.add({{a, c, d}});
  };
  // A dark wall of 1 mm, and bright slats before it, four cells apart.
  add({0, 0, 0}, {0, -10'000, 0}, {0, -10'000, 10'000}, {0, 0, 10'000});
  for (std::int64_t z = 0; z <= 10'000; z += 64) {
    add({-110, 0, z}, {-110, -10'000, z}, {-100, -10'000, z}, {-100, 0, z});
  }
  // Far to the right of them: cells are 16 times as large.
  view.add(
      {{Vertex{100'000, -100'000, 0}, Vertex{100'200, -100'000, 0}, Vertex{100'200, -100'200, 0}}});
  const RgbaPicture picture = view.picture(400, 100);
  int full = 0, dark = 0;
  for (std::size_t i = 0; i < picture.bytes.size(); i += 4) {
    if (picture.bytes[i + 3] < 255) continue;
    ++full;
    if (picture.bytes[i] < 190) ++dark;  // the wall alone has 156, the slats 224
  }
  CHECK_GT(full, 100);
  CHECK_LE(dark, full / 10);
}

TEST_CASE("facets without an area are not there") {
  PartView view;
  view.add({{Vertex{1, 2, 3}, Vertex{1, 2, 3}, Vertex{500'000, 2, 3}}});
  view.add({{Vertex{0, 0, 0}, Vertex{1'000, 1'000, 0}, Vertex{2'000, 2'000, 0}}});
  CHECK(view.empty());
  const RgbaPicture picture = view.picture(16, 20);
  CHECK_EQ(picture.bytes, std::vector<std::uint8_t>(std::size_t{16} * 20 * 4));
}

TEST_CASE("the smallest and the largest parts have a picture") {
  PartView small;
  small.add({{Vertex{0, 0, 0}, Vertex{1, 0, 0}, Vertex{0, 1, 0}}});
  const RgbaPicture dot = small.picture(16, 16);
  CHECK(
      std::any_of(dot.bytes.begin(), dot.bytes.end(), [](std::uint8_t byte) { return byte > 0; }));
  constexpr std::int32_t kFar = 1 << 29;
  constexpr std::int64_t kHigh = std::int64_t{1} << 60;
  small.add(
      {{Vertex{-kFar, -kFar, -kHigh}, Vertex{kFar, -kFar, kHigh}, Vertex{kFar, kFar, kHigh}}});
  CHECK_FALSE(small.empty());
  CHECK_EQ(small.picture(16, 16).bytes.size(), 1'024);
}

TEST_CASE("memory does not depend on what is seen") {
  const std::vector<Triangle> triangles = test::triangles_of(parts::vase(0.05));
  PartView view;
  const std::size_t before = allocations;
  for (const Triangle& t : triangles) view.add(t);
  CHECK_EQ(allocations, before);
}
