#include "host/settings/section_words.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "host/settings/settings_text.h"  // read_number

namespace host {
namespace {

// Bounds of the side of the square that show --zoom draws; no bed is larger.
constexpr double kZoomMinMm = 0.1;
constexpr double kZoomMaxMm = 100'000;

core::Error unknown(const std::string& cause) { return {core::ErrorCode::kBadSetting, cause}; }

}  // namespace

core::Result<SectionPlace> section_place(const std::string& text) {
  SectionPlace place;
  const bool named = text.size() > 2 && text[1] == '=';
  place.axis = named && (text[0] == 'x' || text[0] == 'X') ? 'X' : 'Y';
  const bool known = named && (place.axis == 'X' || text[0] == 'y' || text[0] == 'Y');
  std::string number = known ? text.substr(2) : "";
  place.percent = !number.empty() && number.back() == '%';
  if (place.percent) number.pop_back();
  const core::Result<double> read = read_number(number, "mm");
  if (!known || !read.ok()) {
    return unknown(
        "'" + text +
        "' is no position for a cut; write Y=12.5 for 12.5 mm behind the part's front, X=50% "
        "for the middle between its left and right side");
  }
  place.value = read.value();
  return place;
}

core::Result<SectionZoom> section_zoom(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const core::Result<double> read = read_number(part, "mm");
    if (!read.ok()) break;
    numbers.push_back(read.value());
  }
  const bool three = std::count(text.begin(), text.end(), ',') == 2 && numbers.size() == 3;
  if (!three || numbers[2] < kZoomMinMm || numbers[2] > kZoomMaxMm) {
    return unknown("'" + text +
                   "' is no square; write 4,10,6 for 6 mm around the point 4 mm from the part's "
                   "edge and 10 mm above the bed");
  }
  return SectionZoom{numbers[0], numbers[1], numbers[2]};
}

}  // namespace host
