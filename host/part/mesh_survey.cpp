#include "host/part/mesh_survey.h"

#include <algorithm>

#include "core/facet_sides.h"       // FacetSides
#include "host/part/bed_placing.h"  // mm_text
#include "host/system/limits.h"     // kHeightGapsMax

namespace host {
namespace {

// Facets whose heights are united in one step.
constexpr std::size_t kSpansAtOnce = 1'024;

// A facet leans out if it goes sideways by more than this share of its height.
constexpr double kLeansOut = 1.0 / 64;

// A part whose longest side is shorter than this may be in metres, or in inches.
constexpr std::int64_t kMetresBelow = 10'000, kInchesBelow = 50'000;

}  // namespace

bool is_degenerate(const core::Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return a == b || b == c || c == a;
}

bool can_be_cut(const core::Triangle& triangle) {
  return !is_degenerate(triangle) && triangle.lowest_z() != triangle.highest_z();
}

bool faces_down(const core::Triangle& triangle) {
  const auto [x, y, z] = core::FacetSides(triangle).normal();
  return z < 0 && z * z > kLeansOut * kLeansOut * (x * x + y * y);
}

bool MeshSurvey::nothing_hangs_over(core::Length height) const {
  if (!closed() || turned()) return false;
  return !facing_down_ || *facing_down_ <= extent_.lowest_z + height.units();
}

bool MeshSurvey::add(const core::Triangle& triangle) {
  extent_.add(triangle);
  if (on_facet_) on_facet_(triangle);
  const bool cut = can_be_cut(triangle);
  outermost_.add(triangle, ++facets_, cut);
  if (is_degenerate(triangle)) {
    ++degenerate_;
    return false;
  }
  edges_.add(triangle);
  if (limits_) limits_->add(triangle);
  const std::int64_t low = triangle.lowest_z(), high = triangle.highest_z();
  if (faces_down(triangle)) facing_down_ = std::max(high, facing_down_.value_or(high));
  if (!cut) return false;
  for (const core::Vertex& corner : triangle.corners) {
    fill_.add(corner.z);
    if (corner.z == high && high - low > tallest_.span) tallest_ = {high - low, {corner, facets_}};
  }
  highest_cut_ = std::max(high, highest_cut_.value_or(high));
  order_.add(triangle);
  // Most facets overlap the one before in height.
  if (!spans_.empty() && low <= spans_.back().high && high >= spans_.back().low &&
      spans_.size() > united_) {
    spans_.back() = {std::min(low, spans_.back().low), std::max(high, spans_.back().high)};
    return true;
  }
  spans_.push_back({low, high});
  if (spans_.size() >= united_ + kSpansAtOnce) unite_spans();
  return true;
}

void MeshSurvey::unite_spans() {
  std::sort(spans_.begin(), spans_.end(),
            [](const Span& a, const Span& b) { return a.low < b.low; });
  std::vector<Span> apart;
  for (const Span& span : spans_) {
    if (!apart.empty() && span.low <= apart.back().high) {
      apart.back().high = std::max(apart.back().high, span.high);
    } else {
      apart.push_back(span);
    }
  }
  while (apart.size() > kHeightGapsMax) {
    std::size_t narrowest = 1;
    for (std::size_t i = 2; i < apart.size(); ++i) {
      const auto gap = [&](std::size_t k) { return apart[k].low - apart[k - 1].high; };
      if (gap(i) < gap(narrowest)) narrowest = i;
    }
    apart[narrowest - 1].high = apart[narrowest].high;
    apart.erase(apart.begin() + static_cast<std::ptrdiff_t>(narrowest));
  }
  spans_ = std::move(apart);
  united_ = spans_.size();
}

MeshSurvey::EmptyLayers MeshSurvey::empty_layers(const core::LayerHeights& heights) {
  unite_spans();
  EmptyLayers empty;
  for (std::size_t i = 1; i < spans_.size(); ++i) {
    // Planes above the lower span and not above the start of the upper one.
    const auto planes_up_to = [&](std::int64_t z) {
      return heights.count(core::Length::from_units(z - extent_.lowest_z));
    };
    const core::LayerIndex first = planes_up_to(spans_[i - 1].high);
    const core::LayerIndex count = planes_up_to(spans_[i].low) - first;
    if (count > 0 && empty.count == 0) empty.first = first;
    empty.count += count;
  }
  return empty;
}

MeshSurvey::Gap MeshSurvey::widest_gap() {
  unite_spans();
  Gap widest;
  std::int64_t reached = extent_.lowest_z;
  for (const Span& span : spans_) {
    if (span.low - reached > widest.high - widest.low) widest = {reached, span.low};
    reached = span.high;
  }
  return widest;
}

std::string turned_text(const EdgeLedger::Turned& turned) {
  std::string text = std::string("facets are turned against their neighbours along ") +
                     (turned.exact ? "" : "about ") + std::to_string(turned.edges) +
                     (turned.edges == 1 ? " edge" : " edges");
  if (turned.placed) {
    text += ", the lowest at " + mm_text(turned.lowest.x) + ", " + mm_text(turned.lowest.y) + ", " +
            mm_text(turned.lowest.z) + " mm in the file";
  }
  return text +
         ": some are inside out; contours there that lie within others are taken as holes; "
         "look at the layers with 'rind show', or repair the mesh";
}

std::optional<std::string> unit_question(const MeshExtent& extent) {
  const std::int64_t x = std::int64_t{extent.box.max.x} - extent.box.min.x;
  const std::int64_t y = std::int64_t{extent.box.max.y} - extent.box.min.y;
  const std::int64_t longest = std::max({x, y, extent.highest_z - extent.lowest_z});
  if (longest >= kInchesBelow) return std::nullopt;
  const std::string metres = "in metres (scale it by 1000)", inches = "in inches (by 25.4)";
  return "is it " + (longest < kMetresBelow ? metres + " or " + inches : inches) + "?";
}

std::optional<std::string> unit_warning(const MeshExtent& extent) {
  const std::optional<std::string> question = unit_question(extent);
  if (!question) return std::nullopt;
  return "only " + mm_text(std::int64_t{extent.box.max.x} - extent.box.min.x) + " × " +
         mm_text(std::int64_t{extent.box.max.y} - extent.box.min.y) + " × " +
         mm_text(extent.highest_z - extent.lowest_z) + " mm large: " + *question +
         " It is taken as millimetres";
}

}  // namespace host
