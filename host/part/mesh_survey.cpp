#include "host/part/mesh_survey.h"

#include <algorithm>

#include "core/slices/plane_sweep.h"  // layer_count
#include "host/limits.h"              // kHeightGapsMax

namespace host {
namespace {

// Facets whose heights are taken together.
constexpr std::size_t kSpansAtOnce = 1'024;

// Parts whose longest side is below these are taken to be in metres, in inches.
constexpr std::int64_t kMetresBelow = 10'000, kInchesBelow = 50'000;

bool is_degenerate(const core::Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return a == b || b == c || c == a;
}

// The finaliser of SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t mixed(std::uint64_t number) {
  number = (number ^ number >> 30) * 0xBF58476D1CE4E5B9;
  number = (number ^ number >> 27) * 0x94D049BB133111EB;
  return number ^ number >> 31;
}

std::uint64_t number_of(const core::Vertex& vertex) {
  const std::uint64_t plane = std::uint64_t{static_cast<std::uint32_t>(vertex.x)} << 32 |
                              static_cast<std::uint32_t>(vertex.y);
  return mixed(plane + 0x9E3779B97F4A7C15 * mixed(static_cast<std::uint64_t>(vertex.z) + 1));
}

// Of the edge from a to b; that from b to a is its negative.
std::uint64_t edge_number(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t both = mixed(a + b) + mixed(a ^ b);
  return a < b ? both : 0 - both;
}

}  // namespace

bool can_be_cut(const core::Triangle& triangle) {
  return !is_degenerate(triangle) && triangle.lowest_z() != triangle.highest_z();
}

bool MeshSurvey::add(const core::Triangle& triangle) {
  extent_.add(triangle);
  const bool cut = can_be_cut(triangle);
  outermost_.add(triangle, ++facets_, cut);
  if (is_degenerate(triangle)) {
    ++degenerate_;
    return false;
  }
  const auto& [a, b, c] = triangle.corners;
  const std::uint64_t p = number_of(a), q = number_of(b), r = number_of(c);
  edge_sum_ += edge_number(p, q) + edge_number(q, r) + edge_number(r, p);
  const std::int64_t low = triangle.lowest_z(), high = triangle.highest_z();
  if (!cut) return false;
  for (const core::Vertex& corner : triangle.corners) {
    fill_.add(corner.z);
    if (corner.z == high && high - low > tallest_.span) tallest_ = {high - low, {corner, facets_}};
  }
  highest_cut_ = std::max(high, highest_cut_.value_or(high));
  order_.add(triangle);
  // Most facets stand where the one before stood.
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

MeshSurvey::EmptyLayers MeshSurvey::empty_layers(core::Length layer_height) {
  unite_spans();
  EmptyLayers empty;
  for (std::size_t i = 1; i < spans_.size(); ++i) {
    // Planes above the lower span, and not above the upper one's beginning.
    const auto planes_up_to = [&](std::int64_t z) {
      return core::layer_count(core::Length::from_units(z - extent_.lowest_z), layer_height);
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

std::optional<std::string> unit_warning(const MeshExtent& extent) {
  const std::int64_t x = std::int64_t{extent.box.max.x} - extent.box.min.x;
  const std::int64_t y = std::int64_t{extent.box.max.y} - extent.box.min.y;
  const std::int64_t z = extent.highest_z - extent.lowest_z;
  const std::int64_t longest = std::max({x, y, z});
  if (longest >= kInchesBelow) return std::nullopt;
  const bool metres = longest < kMetresBelow;
  return "only " + mm_text(x) + " × " + mm_text(y) + " × " + mm_text(z) + " mm large: is it in " +
         (metres ? "metres? Then scale it by 1000" : "inches? Then scale it by 25.4");
}

}  // namespace host
