#include "host/formats/slice_stack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/check.h"                  // RIND_CHECK
#include "host/formats/format_limits.h"  // kLayerPointsMax
#include "host/formats/number_text.h"    // parse_real
#include "host/formats/text_scanner.h"   // shown

namespace host {
namespace {

using core::Result;
using core::Status;

struct Unit {
  std::string_view name;
  double mm;
};
// Gap that the rounding of decimals may leave between two stacks.
constexpr double kSliceGapMax_mm = 1e-3;

constexpr std::array<Unit, 6> kUnits{Unit{"micron", 0.001},  Unit{"millimeter", 1},
                                     Unit{"centimeter", 10}, Unit{"inch", 25.4},
                                     Unit{"foot", 304.8},    Unit{"meter", 1'000}};

}  // namespace

std::optional<double> threemf_unit_mm(const std::string& name) {
  for (const Unit& unit : kUnits) {
    if (name == unit.name) return unit.mm;
  }
  return std::nullopt;
}

SliceStack::SliceStack(const ZipArchive& archive, SlicedItem item)
    : archive_(archive), item_(std::move(item)) {
  RIND_CHECK(!item_.stacks.empty());
}

Result<bool> SliceStack::advance() {
  while (true) {
    if (!xml_ || !in_stack_) {
      if (next_stack_ == item_.stacks.size()) return false;
      if (Status opened = open(); !opened.ok()) return opened.error();
    }
    Result<bool> read = read_on();
    if (!read.ok() || read.value()) return read;
    in_stack_ = false;
  }
}

core::Region SliceStack::take_region() { return contours_.take(core::FillRule::kPositive); }

// Opens the next stack at its start.
Status SliceStack::open() {
  const StackPlace& place = item_.stacks[next_stack_++];
  Result<XmlScanner::ByteSource> bytes = archive_.bytes_of(place.part);
  if (!bytes.ok()) return bytes.error();
  xml_.emplace(archive_.name() + " (" + place.part + ")", std::move(bytes).value(), false);
  unit_mm_ = 1;
  while (!in_stack_) {
    const Result<const XmlEvent*> event = xml_->next();
    if (!event.ok()) return event.error();
    if (event.value() == nullptr) {
      return bad("slicestack '" + shown(place.id) + "' is not there; export the part again");
    }
    if (event.value()->kind != XmlEvent::Kind::kStart) continue;
    if (event.value()->space == kThreeMfCore && event.value()->name == "model") {
      const std::string* unit = event.value()->attribute("unit");
      const std::optional<double> mm = unit ? threemf_unit_mm(*unit) : 1.0;
      if (!mm) return bad("unit '" + shown(*unit) + "' is none of 3MF's; export it again");
      unit_mm_ = *mm;
    }
    if (event.value()->space != kThreeMfSlice || event.value()->name != "slicestack") continue;
    const std::string* id = event.value()->attribute("id");
    in_stack_ = id != nullptr && *id == place.id;
    if (!in_stack_) continue;
    if (Status joins = check_start(*event.value(), place.id); !joins.ok()) return joins.error();
  }
  return {};
}

// A stack must start where the one before ends: a gap would become one slab.
Status SliceStack::check_start(const XmlEvent& stack, const std::string& id) const {
  const std::string* text = stack.attribute("zbottom");
  if (!top_mm_ || text == nullptr) return {};
  const std::optional<double> zbottom = parse_real(*text);
  if (zbottom && std::abs(*zbottom * unit_mm_ - *top_mm_) <= kSliceGapMax_mm) return {};
  return bad("slicestack '" + shown(id) + "' begins at zbottom '" + shown(*text) +
             "', not where the one before ends; export the part again");
}

Result<bool> SliceStack::read_on() {
  while (true) {
    const Result<const XmlEvent*> event = xml_->next();
    if (!event.ok()) return event.error();
    if (event.value() == nullptr) return bad("the document ends within a slicestack");
    if (event.value()->space != kThreeMfSlice) continue;
    const bool starts = event.value()->kind == XmlEvent::Kind::kStart;
    if (event.value()->name == "slicestack" && !starts) return false;
    if (event.value()->name == "sliceref" && starts) {
      return bad("a slicestack that is referred to refers to others itself; export it again");
    }
    if (event.value()->name != "slice" || !starts) continue;
    if (Status read = read_slice(*event.value()); !read.ok()) return read.error();
    return true;
  }
}

Status SliceStack::read_slice(const XmlEvent& slice) {
  const std::string* text = slice.attribute("ztop");
  const std::optional<double> ztop = text ? parse_real(*text) : std::nullopt;
  if (!ztop) return bad("a slice without a number for ztop; export the part again");
  const double shift_mm = item_.transform.m[11];
  const double below_mm = top_mm_.value_or(item_.bottom_mm);
  top_mm_ = *ztop * unit_mm_;
  const std::optional<std::int64_t> bottom = height_units(below_mm + shift_mm);
  const std::optional<std::int64_t> top = height_units(*top_mm_ + shift_mm);
  if (!bottom || !top || *top <= *bottom) {
    return bad("the slice with ztop '" + shown(*text) +
               "' does not lie above the one before, or is out of range; export the part again");
  }
  bottom_ = *bottom;
  top_ = *top;
  vertices_.clear();
  polygon_.clear();
  while (true) {
    const Result<const XmlEvent*> event = xml_->next();
    if (!event.ok()) return event.error();
    if (event.value() == nullptr) return bad("the document ends within a slice");
    if (event.value()->space != kThreeMfSlice) continue;
    const bool ends = event.value()->kind == XmlEvent::Kind::kEnd;
    if (ends && event.value()->name == "slice") return {};
    Status taken;
    if (ends && event.value()->name == "polygon") taken = end_polygon();
    if (event.value()->kind == XmlEvent::Kind::kStart) taken = take(*event.value());
    if (!taken.ok()) return taken;
  }
}

Status SliceStack::take(const XmlEvent& event) {
  if (event.name == "vertex") return vertex(event);
  const bool starts = event.name == "polygon";
  if (!starts && event.name != "segment") return {};
  if (starts) polygon_.clear();
  const Result<std::size_t> at = number(event, starts ? "startv" : "v2");
  if (!at.ok()) return at.error();
  if (polygon_.size() > kLayerPointsMax) {
    return bad("a polygon of more than " + std::to_string(kLayerPointsMax) +
               " points, which is more than fits; simplify the part");
  }
  polygon_.push_back(at.value());
  return {};
}

Status SliceStack::vertex(const XmlEvent& event) {
  PointMm at{};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string* text = event.attribute(i == 0 ? "x" : "y");
    const std::optional<double> value = text ? parse_real(*text) : std::nullopt;
    if (!value) return bad("a vertex without a number for x or y; export the part again");
    at[i] = *value * unit_mm_;
  }
  if (vertices_.size() >= kLayerPointsMax) {
    return bad("a slice of more than " + std::to_string(kLayerPointsMax) +
               " points, which is more than fits; simplify the part");
  }
  const PointMm placed = item_.transform.applied(at);
  const std::optional<core::Point> point = snapped(placed[0], placed[1]);
  if (!point) return bad(too_far(placed[0], placed[1]));
  vertices_.push_back(*point);
  return {};
}

Result<std::size_t> SliceStack::number(const XmlEvent& event, const char* name) const {
  const std::string* text = event.attribute(name);
  const std::optional<std::int64_t> index = text ? parse_integer(*text) : std::nullopt;
  if (index && *index >= 0 && static_cast<std::uint64_t>(*index) < vertices_.size()) {
    return static_cast<std::size_t>(*index);
  }
  return bad(std::string(name) + " '" + (text ? shown(*text) : std::string()) +
             "' is no vertex of its slice's " + std::to_string(vertices_.size()) +
             "; export the part again");
}

Status SliceStack::end_polygon() {
  if (polygon_.size() < 2 || polygon_.front() != polygon_.back()) {
    left_polygons_out_ = left_polygons_out_ || !polygon_.empty();
    polygon_.clear();
    return {};
  }
  if (item_.transform.mirrors()) std::reverse(polygon_.begin(), polygon_.end());
  std::string cause = contours_.start();
  for (std::size_t i = 0; i < polygon_.size() && cause.empty(); ++i) {
    cause = contours_.add(vertices_[polygon_[i]]);
  }
  if (!cause.empty()) return bad(cause);
  contours_.end();
  polygon_.clear();
  return {};
}

}  // namespace host
