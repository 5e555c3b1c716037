#include "tests/support/region_corpus.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/support/region_text.h"

namespace test {

using core::Length;
using core::Ring;

namespace {

core::FillRule fill_of(const std::string& word) {
  if (word == "nonzero") return core::FillRule::kNonZero;
  if (word == "evenodd") return core::FillRule::kEvenOdd;
  REQUIRE_EQ(word, "positive");
  return core::FillRule::kPositive;
}

void take(const std::string& key, const std::string& value, CorpusRegion& region) {
  std::istringstream words(value);
  if (key == "name") {
    region.name = value;
  } else if (key == "fill") {
    region.fill = fill_of(value);
  } else if (key == "ring") {
    region.rings.push_back(rings_from_text(value).at(0));
  } else if (key == "clean") {
    region.clean = value == "yes";
  } else if (key == "area_mm2") {
    region.area_mm2 = std::stod(value);
  } else if (key == "islands") {
    region.islands = std::stoul(value);
  } else if (key == "holes") {
    region.holes = std::stoul(value);
  } else if (key == "offset") {
    double depth_mm = 0, area_mm2 = 0;
    words >> depth_mm >> area_mm2;
    REQUIRE_FALSE(words.fail());
    region.offsets.push_back({Length::from_mm(depth_mm), area_mm2});
  } else {
    FAIL("unknown key: " << key);
  }
}

CorpusRegion read(const std::filesystem::path& path) {
  CAPTURE(path.string());
  std::ifstream file(path);
  CorpusRegion region;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::size_t colon = line.find(": ");
    REQUIRE_NE(colon, std::string::npos);
    take(line.substr(0, colon), line.substr(colon + 2), region);
  }
  REQUIRE_EQ(region.name, path.stem().string());
  return region;
}

}  // namespace

std::vector<CorpusRegion> region_corpus() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(RIND_SOURCE_DIR) + "/tests/corpus")) {
    if (entry.path().extension() == ".region") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<CorpusRegion> regions;
  for (const std::filesystem::path& path : paths) regions.push_back(read(path));
  REQUIRE_GE(regions.size(), 20);
  return regions;
}

// A byte is a point, x in its low half, 0 … 14, y in its high half; 15 in the low half ends a ring.
std::vector<std::uint8_t> fuzz_seed(const CorpusRegion& region) {
  core::Box box;
  for (const Ring& ring : region.rings) box.add(core::box_of(ring));
  const double width = std::max(1.0, static_cast<double>(box.max.x) - box.min.x);
  const double height = std::max(1.0, static_cast<double>(box.max.y) - box.min.y);
  // An offset by 5/4 of a grid step, and a large scale.
  std::vector<std::uint8_t> bytes{4, 4};
  for (const Ring& ring : region.rings) {
    for (const core::Point p : ring) {
      const auto x = static_cast<int>(std::lround((p.x - box.min.x) / width * 14));
      const auto y = static_cast<int>(std::lround((p.y - box.min.y) / height * 15));
      const auto byte = static_cast<std::uint8_t>(x + 16 * y);
      if (bytes.back() != byte) bytes.push_back(byte);
    }
    bytes.push_back(15);
  }
  return bytes;
}

}  // namespace test
