// The body of a printed test: convex prisms that reach into one another, and labels in raised
// digits. Lengths are in mm; x to the right, y to the back, z up from the bed.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace host {

struct Span {
  double from = 0;
  double to = 0;
};

// In the plane of a prism's outline.
struct Place {
  double u = 0;
  double v = 0;
};

// From where a label is read.
enum class LabelSide { kFront, kBack };

// A digit in seven strokes.
struct LabelForm {
  double height = 3;
  double thick = 0.6;  // of level strokes
  double stroke = 1;   // its width; a digit is three wide, a gap one
  double raised = 0.6;
};

class TestSolid {
 public:
  using Corner = std::array<double, 3>;
  using Facet = std::array<Corner, 3>;  // counter-clockwise seen from outside

  // REQUIRES: from < to in each.
  void box(Span x, Span y, Span z);

  // The outline is convex, counter-clockwise seen from above.
  void upright(const std::vector<Place>& outline, Span z);

  // The outline is convex, in x and z, counter-clockwise seen from the front.
  void across(const std::vector<Place>& outline, Span y);

  // Digits, '.' and '-', their middle at x, on the face of a body at y.
  void label(std::string_view text, double x, double y, double bottom, LabelSide side,
             const LabelForm& form);

  [[nodiscard]] const std::vector<Facet>& facets() const { return facets_; }
  [[nodiscard]] Span extent(std::size_t axis) const;
  // A binary STL.
  [[nodiscard]] std::string stl() const;

 private:
  template <typename Map>
  void prism(const std::vector<Place>& outline, Span depth, const Map& at);

  std::vector<Facet> facets_;
};

[[nodiscard]] double label_width(std::string_view text, const LabelForm& form);

}  // namespace host
