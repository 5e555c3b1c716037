#include "host/formats/threemf_elements.h"

#include <optional>
#include <string>
#include <string_view>

#include "host/formats/format_limits.h"  // kWordBytesMax
#include "host/formats/number_text.h"    // parse_real
#include "host/formats/slice_stack.h"    // threemf_unit_mm
#include "host/formats/text_scanner.h"   // is_blank, shown

namespace host {
namespace {

using core::Result;

// Extensions that a file may require: they are supported, or don't change the shape.
constexpr std::array<std::string_view, 5> kKnownExtensions{
    "http://schemas.microsoft.com/3dmanufacturing/core/",
    "http://schemas.microsoft.com/3dmanufacturing/production/",
    "http://schemas.microsoft.com/3dmanufacturing/material/",
    "http://schemas.microsoft.com/3dmanufacturing/slice/",
    "http://schemas.microsoft.com/3dmanufacturing/triangleset"};

// The next word of a list separated by blanks; empty at its end.
std::string_view take_word(std::string_view& list) {
  while (!list.empty() && is_blank(static_cast<unsigned char>(list.front()))) list.remove_prefix(1);
  std::size_t end = 0;
  while (end < list.size() && !is_blank(static_cast<unsigned char>(list[end]))) ++end;
  const std::string_view word = list.substr(0, end);
  list.remove_prefix(end);
  return word;
}

std::string_view local_name(std::string_view name) { return name.substr(name.rfind('|') + 1); }

// Attributes are as a rule in the order in which the standard names them.
const std::string* attribute_at(const XmlEvent& event, std::size_t place, std::string_view name) {
  if (place < event.attributes.size() && event.attributes[place].first == name) {
    return &event.attributes[place].second;
  }
  return event.attribute(name);
}

}  // namespace

Result<double> unit_of(const XmlEvent& event, const XmlScanner& xml) {
  double unit_mm = 1;
  if (const std::string* unit = event.attribute("unit")) {
    const std::optional<double> mm = threemf_unit_mm(*unit);
    if (!mm) return xml.bad("unit '" + shown(*unit) + "' is none of 3MF's; export it again");
    unit_mm = *mm;
  }
  const std::string* required = event.attribute("requiredextensions");
  if (required == nullptr) return unit_mm;
  std::string_view list = *required;
  for (std::string_view word = take_word(list); !word.empty(); word = take_word(list)) {
    const std::string uri = xml.namespace_of(std::string(word));
    bool known = false;
    for (const std::string_view extension : kKnownExtensions) {
      known = known || uri.starts_with(extension);
    }
    if (!known) {
      return xml.bad("the file requires the extension '" +
                     shown(uri.empty() ? word : uri, kWordBytesMax) +
                     "', which is not supported; export plain 3MF or STL");
    }
  }
  return unit_mm;
}

Result<PointMm> point_of(const XmlEvent& event, const XmlScanner& xml, double unit_mm) {
  PointMm point{};
  constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string* text = attribute_at(event, i, kNames[i]);
    const std::optional<double> value = text ? parse_real(*text) : std::nullopt;
    if (!value) return xml.bad("a vertex without a number for x, y or z; export the part again");
    point[i] = *value * unit_mm;
  }
  return point;
}

Result<std::array<std::uint32_t, 3>> corners_of(const XmlEvent& event, const XmlScanner& xml,
                                                std::size_t vertices) {
  std::array<std::uint32_t, 3> corners{};
  constexpr std::array<std::string_view, 3> kNames{"v1", "v2", "v3"};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string* text = attribute_at(event, i, kNames[i]);
    const std::optional<std::int64_t> index = text ? parse_integer(*text) : std::nullopt;
    const bool known = index && *index >= 0 && static_cast<std::uint64_t>(*index) < vertices;
    if (!known) {
      return xml.bad("a triangle's corner '" + (text ? shown(*text) : std::string()) +
                     "' is no vertex of its object's " + std::to_string(vertices) +
                     "; export the part again");
    }
    corners[i] = static_cast<std::uint32_t>(*index);
  }
  return corners;
}

std::string_view support_paint_of(const XmlEvent& event) {
  for (const auto& [name, value] : event.attributes) {
    const std::string_view local = local_name(name);
    if (local == "custom_supports" || local == "paint_supports") return value;
  }
  return {};
}

bool has_other_paint(const XmlEvent& event) {
  for (const auto& [name, value] : event.attributes) {
    const std::string_view local = local_name(name);
    if (local == "custom_supports" || local == "paint_supports") continue;
    if (local.starts_with("paint_") || local.starts_with("custom_") ||
        local == "mmu_segmentation" || local == "fuzzy_skin") {
      return true;
    }
  }
  return false;
}

Result<Transform> transform_of(const XmlEvent& event, const XmlScanner& xml, double unit_mm) {
  Transform result;
  const std::string* text = event.attribute("transform");
  if (text == nullptr) return result;
  std::string_view list = *text;
  for (std::size_t i = 0; i < result.m.size(); ++i) {
    const std::optional<double> value = parse_real(take_word(list));
    if (!value) return xml.bad("'" + shown(*text) + "' is no transform; export the part again");
    result.m[i] = i < 9 ? *value : *value * unit_mm;
  }
  return result;
}

}  // namespace host
