#include "host/output/thumbnail_text.h"

#include <doctest/doctest.h>

#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "host/output/base64.h"
#include "host/output/part_view.h"
#include "host/output/png_writer.h"
#include "host/output/qoi_writer.h"
#include "tests/support/mesh.h"
#include "tools/parts/part_maker.h"

using host::read_thumbnails;
using host::Thumbnail;
using host::ThumbnailFormat;

namespace {

std::vector<Thumbnail> read(const std::string& text) {
  const auto thumbnails = read_thumbnails(text, ThumbnailFormat::kPng);
  if (!thumbnails.ok()) FAIL(thumbnails.error().message);
  return thumbnails.value();
}

}  // namespace

TEST_CASE("sizes and formats are read as PrusaSlicer writes them") {
  CHECK(read("").empty());
  CHECK(read("  ").empty());
  const std::vector<Thumbnail> two = read("16x16/QOI, 220x124/PNG");
  REQUIRE_EQ(two.size(), 2);
  CHECK_EQ(two[0].width, 16);
  CHECK_EQ(two[0].format, ThumbnailFormat::kQoi);
  CHECK_EQ(two[1].width, 220);
  CHECK_EQ(two[1].height, 124);
  CHECK_EQ(two[1].format, ThumbnailFormat::kPng);
  CHECK_EQ(read("32x32,300x300, ").size(), 2);
  const auto of_format = read_thumbnails("800x16, 16x16/png", ThumbnailFormat::kQoi);
  REQUIRE(of_format.ok());
  CHECK_EQ(of_format.value()[0].format, ThumbnailFormat::kQoi);
  CHECK_EQ(of_format.value()[1].format, ThumbnailFormat::kPng);
}

TEST_CASE("what is no thumbnail is told") {
  for (const char* text :
       {"15x16", "16x801", "300", "x300", "300x", "300x300/JPG", "300x300/", "-32x32", "32x-32",
        "3e2x32", "32x32x32", "32x32,,32x32", "99999999999x32", "32 x32", ",", "a"}) {
    CAPTURE(text);
    const auto read = read_thumbnails(text, ThumbnailFormat::kPng);
    REQUIRE_FALSE(read.ok());
    CHECK_EQ(read.error().code, core::ErrorCode::kBadSetting);
  }
  std::string many = "32x32";
  for (std::size_t i = 1; i < host::kThumbnailsMax; ++i) many += ", 32x32";
  CHECK_EQ(read(many).size(), host::kThumbnailsMax);
  CHECK_FALSE(read_thumbnails(many + ", 32x32", ThumbnailFormat::kPng).ok());
}

TEST_CASE("the comments hold the pictures, 78 characters a line") {
  host::PartView view;
  for (const core::Triangle& t : test::triangles_of(parts::demo())) view.add(t);
  std::string gcode;
  append_thumbnails(view, read("48x32/QOI, 220x124"), gcode);
  std::string text;
  std::vector<std::string> heads, texts;
  std::istringstream lines(gcode);
  for (std::string line; std::getline(lines, line);) {
    CHECK_LE(line.size(), 80);
    REQUIRE(line.starts_with(';'));
    if (line.find(" begin ") != std::string::npos) {
      heads.push_back(line);
      text.clear();
    } else if (line.ends_with(" end")) {
      texts.push_back(text);
      CHECK_EQ(heads.back().substr(0, line.size() - 4), line.substr(0, line.size() - 4));
    } else if (line != ";") {
      text += line.substr(2);
    }
  }
  const std::string qoi = host::base64_of(host::qoi_of(view.picture(48, 32)));
  const std::string png = host::base64_of(host::png_of(view.picture(220, 124)));
  CHECK_EQ(texts, std::vector<std::string>{qoi, png});
  CHECK_EQ(heads,
           std::vector<std::string>{"; thumbnail_QOI begin 48x32 " + std::to_string(qoi.size()),
                                    "; thumbnail begin 220x124 " + std::to_string(png.size())});
}
