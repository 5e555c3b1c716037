#include "host/calibration/test_solid.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/check.h"  // RIND_CHECK

namespace host {
namespace {

// How deep a digit reaches into what it stands on.
constexpr double kSunk_mm = 0.4;
// Strokes that meet have no face in common, so that a cut through both is plain.
constexpr double kApart_mm = 0.03;

// The strokes of a digit, from the top clockwise, then the middle.
enum Stroke : unsigned {
  kTop = 1,
  kUpperRight = 2,
  kLowerRight = 4,
  kBottom = 8,
  kLowerLeft = 16,
  kUpperLeft = 32,
  kMiddle = 64,
};

constexpr unsigned kRight = kUpperRight | kLowerRight;
constexpr unsigned kLeft = kUpperLeft | kLowerLeft;

constexpr std::array<unsigned, 10> kDigits = {
    kTop | kRight | kBottom | kLeft,
    kRight,
    kTop | kUpperRight | kMiddle | kLowerLeft | kBottom,
    kTop | kRight | kMiddle | kBottom,
    kUpperLeft | kMiddle | kRight,
    kTop | kUpperLeft | kMiddle | kLowerRight | kBottom,
    kTop | kLeft | kMiddle | kLowerRight | kBottom,
    kTop | kRight,
    kTop | kRight | kBottom | kLeft | kMiddle,
    kTop | kRight | kBottom | kUpperLeft | kMiddle,
};

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

unsigned strokes_of(char letter) {
  if (letter == '-') return kMiddle;
  return is_digit(letter) ? kDigits[static_cast<std::size_t>(letter - '0')] : 0;
}

double letter_width(char letter, double stroke) { return letter == '.' ? stroke : 3 * stroke; }

void append_number(std::uint32_t number, std::string& bytes) {
  for (const int shift : {0, 8, 16, 24}) bytes += static_cast<char>(number >> shift & 0xFFU);
}

void append_coordinate(double mm, std::string& bytes) {
  append_number(std::bit_cast<std::uint32_t>(static_cast<float>(mm)), bytes);
}

}  // namespace

template <typename Map>
void TestSolid::prism(const std::vector<Place>& outline, Span depth, const Map& at) {
  RIND_CHECK(outline.size() >= 3 && depth.from < depth.to);
  const std::size_t count = outline.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Place a = outline[i], b = outline[(i + 1) % count];
    facets_.push_back({at(a, depth.from), at(b, depth.from), at(b, depth.to)});
    facets_.push_back({at(a, depth.from), at(b, depth.to), at(a, depth.to)});
    if (i == 0 || i + 1 == count) continue;
    facets_.push_back({at(outline[0], depth.to), at(a, depth.to), at(b, depth.to)});
    facets_.push_back({at(outline[0], depth.from), at(b, depth.from), at(a, depth.from)});
  }
}

void TestSolid::upright(const std::vector<Place>& outline, Span z) {
  prism(outline, z, [](Place place, double height) { return Corner{place.u, place.v, height}; });
}

void TestSolid::across(const std::vector<Place>& outline, Span y) {
  // Seen from the front, depth grows towards the eye.
  prism(outline, {-y.to, -y.from}, [](Place place, double depth) {
    return Corner{place.u, -depth, place.v};
  });
}

void TestSolid::box(Span x, Span y, Span z) {
  upright({{x.from, y.from}, {x.to, y.from}, {x.to, y.to}, {x.from, y.to}}, z);
}

void TestSolid::label(std::string_view text, double x, double y, double bottom, LabelSide side,
                      const LabelForm& form) {
  const bool front = side == LabelSide::kFront;
  // Outwards from the face at y.
  const auto depth = [&](double sunk, double raised) {
    return front ? Span{y - raised, y + sunk} : Span{y - sunk, y + raised};
  };
  const double thick = form.thick;
  const double middle = bottom + form.height / 2, top = bottom + form.height;
  double along = -label_width(text, form) / 2;  // from the label's middle, as it is read
  const auto across = [&](Span u) {
    return front ? Span{x + u.from, x + u.to} : Span{x - u.to, x - u.from};
  };
  const auto stroke = [&](Span u, Span z) { box(across(u), depth(kSunk_mm, form.raised), z); };
  for (const char letter : text) {
    const double width = letter_width(letter, form.stroke);
    const Span whole{along, along + width};
    along += width + form.stroke;
    if (letter == '.') stroke(whole, {bottom, bottom + thick});
    const unsigned strokes = strokes_of(letter);
    if ((strokes & kTop) != 0) stroke(whole, {top - thick, top});
    if ((strokes & kMiddle) != 0) stroke(whole, {middle - thick / 2, middle + thick / 2});
    if ((strokes & kBottom) != 0) stroke(whole, {bottom, bottom + thick});
    const auto side_strokes = [&](unsigned upper, unsigned lower, Span u) {
      if ((strokes & (upper | lower)) == 0) return;
      const Span z{(strokes & lower) != 0 ? bottom : middle - thick / 2,
                   (strokes & upper) != 0 ? top : middle + thick / 2};
      box(across(u), depth(kSunk_mm + kApart_mm, form.raised - kApart_mm), z);
    };
    side_strokes(kUpperLeft, kLowerLeft, {whole.from + kApart_mm, whole.from + form.stroke});
    side_strokes(kUpperRight, kLowerRight, {whole.to - form.stroke, whole.to - kApart_mm});
  }
}

Span TestSolid::extent(std::size_t axis) const {
  RIND_CHECK(!facets_.empty() && axis < 3);
  Span extent{facets_[0][0][axis], facets_[0][0][axis]};
  for (const Facet& facet : facets_) {
    for (const Corner& corner : facet) {
      extent = {std::min(extent.from, corner[axis]), std::max(extent.to, corner[axis])};
    }
  }
  return extent;
}

std::string TestSolid::stl() const {
  std::string bytes(80, ' ');
  append_number(static_cast<std::uint32_t>(facets_.size()), bytes);
  for (const Facet& facet : facets_) {
    bytes.append(12, '\0');  // the normal, which readers compute
    for (const Corner& corner : facet) {
      for (const double mm : corner) append_coordinate(mm, bytes);
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

double label_width(std::string_view text, const LabelForm& form) {
  double width = text.empty() ? 0 : -form.stroke;
  for (const char letter : text) width += letter_width(letter, form.stroke) + form.stroke;
  return width;
}

}  // namespace host
