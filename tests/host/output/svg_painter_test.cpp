// Pictures in pixels: colours are compared with what lies at a pixel's place, found by other means.
#include "host/output/svg_painter.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/sections/layer_window.h"
#include "host/output/layer_picture.h"
#include "host/output/raster_canvas.h"
#include "host/output/stroke_letters.h"
#include "host/output/stroke_outline.h"
#include "tests/support/prism_window.h"

using core::Length;
using core::Road;
using core::RoadKind;
using host::Pixel;
using host::PixelOutline;

namespace {

using Colour = std::uint32_t;  // 0xRRGGBB

Colour at(const host::RgbaPicture& picture, int x, int y) {
  const std::size_t first =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
           static_cast<std::size_t>(x));
  const auto part = [&](std::size_t i) { return Colour{picture.bytes[first + i]}; };
  return part(0) << 16 | part(1) << 8 | part(2);
}

Colour of(const char* text) { return static_cast<Colour>(std::stoul(text + 1, nullptr, 16)); }

// How often the outlines wind round a point, by the angle that they turn through.
int winding(const std::vector<PixelOutline>& outlines, Pixel p) {
  double turned = 0;
  for (const PixelOutline& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Pixel a = outline[i], b = outline[(i + 1) % outline.size()];
      const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y;
      turned += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    }
  }
  return static_cast<int>(std::lround(turned / (2 * std::acos(-1.0))));
}

double distance(Pixel p, Pixel a, Pixel b) {
  const double dx = b.x - a.x, dy = b.y - a.y, whole = dx * dx + dy * dy;
  const double along = whole == 0 ? 0 : ((p.x - a.x) * dx + (p.y - a.y) * dy) / whole;
  const double share = std::min(1.0, std::max(0.0, along));
  return std::hypot(p.x - a.x - share * dx, p.y - a.y - share * dy);
}

double border_distance(const std::vector<PixelOutline>& outlines, Pixel p) {
  double nearest = 1e9;
  for (const PixelOutline& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      nearest = std::min(nearest, distance(p, outline[i], outline[(i + 1) % outline.size()]));
    }
  }
  return nearest;
}

core::Ring square(std::int32_t low, std::int32_t high) {
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}

}  // namespace

TEST_CASE("an area covers the pixels that it winds round, and no others") {
  constexpr unsigned kSeed = 20261129;
  CAPTURE(kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> place(-10, 70);
  for (int round = 0; round < 40; ++round) {
    std::vector<PixelOutline> outlines(static_cast<std::size_t>(1 + round % 3));
    for (PixelOutline& outline : outlines) {
      for (int i = 0; i < 3 + round % 7; ++i) outline.push_back({place(random), place(random)});
    }
    host::RasterCanvas canvas(60, 50);
    canvas.fill(outlines, {0, 0, 0, 1}, {});
    int wrong = 0, inside = 0;
    double covered = 0, sampled = 0;
    for (int y = 0; y < 50; ++y) {
      for (int x = 0; x < 60; ++x) {
        const Pixel middle{x + 0.5, y + 0.5};
        const Colour colour = at(canvas.picture(), x, y);
        covered += 1 - (colour & 0xFFU) / 255.0;
        const bool in = winding(outlines, middle) != 0;
        sampled += in ? 1 : 0;
        if (border_distance(outlines, middle) < 0.75) continue;
        inside += in ? 1 : 0;
        wrong += colour == (in ? 0x000000U : 0xFFFFFFU) ? 0 : 1;
      }
    }
    CHECK_EQ(wrong, 0);
    // Where edges pass, shares of pixels add up to the area.
    CHECK(std::abs(covered - sampled) < 0.02 * 3'000);
    if (round == 0) CHECK(inside > 0);
  }
}

TEST_CASE("half of a pixel is half of its colour, and a clip cuts") {
  host::RasterCanvas canvas(4, 4);
  canvas.fill({{{0.5, 1}, {2.25, 1}, {2.25, 3}, {0.5, 3}}}, {0, 0, 0, 1}, {0, 0, 4, 2});
  CHECK_EQ(at(canvas.picture(), 0, 1), 0x808080);
  CHECK_EQ(at(canvas.picture(), 1, 1), 0x000000);
  CHECK_EQ(at(canvas.picture(), 2, 1), 0xBFBFBF);
  CHECK_EQ(at(canvas.picture(), 1, 0), 0xFFFFFF);
  CHECK_EQ(at(canvas.picture(), 1, 2), 0xFFFFFF);
}

TEST_CASE("a line covers what is nearer to it than half its width") {
  const std::vector<Pixel> bend = {{10, 10}, {50, 12}, {52, 40}, {14, 44}, {30, 20}};
  for (const double width : {1.5, 6.0, 13.0}) {
    for (const bool closed : {false, true}) {
      CAPTURE(width);
      CAPTURE(closed);
      std::vector<PixelOutline> outlines;
      host::append_stroke(bend, closed, {width, true}, outlines);
      host::RasterCanvas canvas(64, 64);
      canvas.fill(outlines, {0, 0, 0, 1}, {});
      int wrong = 0;
      for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
          double nearest = 1e9;
          for (std::size_t i = 0; i + (closed ? 0 : 1) < bend.size(); ++i) {
            nearest = std::min(nearest,
                               distance({x + 0.5, y + 0.5}, bend[i], bend[(i + 1) % bend.size()]));
          }
          const double over = nearest - width / 2;
          if (std::abs(over) < 0.8) continue;
          wrong += at(canvas.picture(), x, y) == (over < 0 ? 0x000000U : 0xFFFFFFU) ? 0 : 1;
        }
      }
      CHECK_EQ(wrong, 0);
    }
  }
}

TEST_CASE("a layer's picture shows at each place the road that lies there, or the bare part") {
  const core::LayerWindow window = test::window_in_prism(core::Settings());
  const std::vector<Road> roads = {
      {RoadKind::kOuterPerimeter, Length::from_mm(0.8), true, square(10'000, 90'000)},
      {RoadKind::kLoose, Length::from_mm(1.2), false, {{20'000, 20'000}, {80'000, 70'000}}}};
  const std::string svg = host::draw_layer({"a & b", &window, &roads, "µ and ² and ü"});
  host::SvgPainter painter;
  painter.paint(svg);
  CHECK_EQ(painter.png().substr(0, 4), "\x89PNG");

  // The right panel: its place and scale are read from the drawing.
  const std::size_t panel = svg.find("<g transform=", svg.find("<g transform=") + 1);
  double left = 0, bottom = 0, scale = 0, down = 0, x0 = 0, y0 = 0;
  REQUIRE_EQ(std::sscanf(svg.c_str() + panel,
                         "<g transform=\"translate(%lf %lf) scale(%lf %lf) translate(%lf %lf)\"",
                         &left, &bottom, &scale, &down, &x0, &y0),
             6);
  int wrong = 0, body = 0, edge = 0, bare = 0;
  for (int step = 0; step < 90'000; ++step) {
    const int x = static_cast<int>(left) + 2 * (step % 300),
              y = static_cast<int>(bottom) - 2 * (step / 300);
    const Pixel mm{(x + 0.5 - left) / scale - x0, (bottom - y - 0.5) / scale - y0};
    if (mm.x < 0.1 || mm.y < 0.1 || mm.x > 9.9 || mm.y > 9.9) continue;
    double perimeter = 1e9;
    const std::vector<Pixel> ring = {{1, 1}, {9, 1}, {9, 9}, {1, 9}};
    for (std::size_t i = 0; i < 4; ++i) {
      perimeter = std::min(perimeter, distance(mm, ring[i], ring[(i + 1) % 4]));
    }
    const double loose = distance(mm, {2, 2}, {8, 7});
    const double near = 1.0 / scale;
    const auto border = [&](double from, double width) {
      return std::abs(from - width / 2) < near || std::abs(from - 0.37 * width) < near;
    };
    if (border(perimeter, 0.8) || border(loose, 1.2)) continue;
    const char* expected = "#f1eee8";
    if (perimeter < 0.4) expected = perimeter < 0.296 ? "#c8502f" : "#7d2a17";
    if (loose < 0.6) expected = loose < 0.444 ? "#5f9bb3" : "#2c5d72";
    wrong += at(painter.picture(), x, y) == of(expected) ? 0 : 1;
    body += loose < 0.444 ? 1 : 0, edge += perimeter < 0.4 ? 1 : 0;
    bare += perimeter > 0.5 && loose > 0.7 ? 1 : 0;
  }
  CHECK_EQ(wrong, 0);
  CHECK(std::min({body, edge, bare}) > 500);
}

TEST_CASE("every letter has lines within its place, and unknown ones a box") {
  for (char letter = '!'; letter <= '~'; ++letter) {
    CAPTURE(letter);
    const std::string text(1, letter);
    const auto lines = host::text_lines(text, {100, 50}, 14);
    REQUIRE_FALSE(lines.empty());
    const auto box = host::text_lines("\u4e00", {100, 50}, 14);
    for (const auto& line : lines) {
      REQUIRE_FALSE(line.empty());
      for (const Pixel point : line) {
        CHECK(point.x >= 100 - 1e-9);
        CHECK(point.x <= 100 + host::text_width(text, 14));
        CHECK(point.y >= 50 - 14);
        CHECK(point.y <= 50 + 5);
      }
    }
    CHECK_FALSE((lines.size() == box.size() && lines[0].size() == box[0].size() &&
                 std::abs(lines[0][2].x - box[0][2].x) < 1e-9 && lines[0].size() == 5));
  }
  CHECK(host::text_lines(" ", {0, 0}, 14).empty());
  CHECK_FALSE(host::text_lines("\xff", {0, 0}, 14).empty());
  CHECK_EQ(host::text_width("ab", 28), doctest::Approx(2 * host::text_width("ab", 14)));
}

TEST_CASE("a page that is too large is painted smaller") {
  host::SvgPainter painter;
  painter.paint(
      "<svg width=\"1000\" height=\"16000\" viewBox=\"0 0 1000 16000\" fill=\"#222\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fdfcfa\"/>\n");
  CHECK(painter.picture().bytes.size() <= 4 * 4'000'000);
  CHECK(painter.scale() == doctest::Approx(0.5));
  CHECK_EQ(painter.picture().width, 500);
}
