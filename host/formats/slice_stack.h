// Reads a stack of slices of a 3MF package (slice extension 1.0.2), one slice at a time:
//
//     <slicestack id zbottom>   slices, or references to stacks in other parts of the package
//       <slice ztop>            vertices, then polygons of segments from vertex to vertex
//
// A point is inside if its winding number is positive: outer contours are counter-clockwise. Each
// slice reaches down to the one before, the first to zbottom. Open polygons are left out.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/regions/region.h"            // Region
#include "core/result.h"                    // Result, Status
#include "host/formats/contour_gatherer.h"  // ContourGatherer
#include "host/formats/mesh_store.h"        // Transform
#include "host/formats/xml_scanner.h"       // XmlScanner
#include "host/formats/zip_archive.h"       // ZipArchive

namespace host {

inline constexpr std::string_view kThreeMfCore =
    "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
inline constexpr std::string_view kThreeMfSlice =
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07";

// A <slicestack> in a model part of the package.
struct StackPlace {
  std::string part;
  std::string id;
};

// A build item that consists of slices. REQUIRES: `transform` changes heights only by a shift.
struct SlicedItem {
  std::vector<StackPlace> stacks;  // one on top of the other
  double bottom_mm = 0;            // of the first
  Transform transform;
};

// The unit in mm; nullopt if 3MF has no such unit.
[[nodiscard]] std::optional<double> threemf_unit_mm(const std::string& name);

class SliceStack {
 public:
  // REQUIRES: `archive` outlives it
  SliceStack(const ZipArchive& archive, SlicedItem item);

  // Advances to the next slice, at first to the first one; false at the end.
  [[nodiscard]] core::Result<bool> advance();

  // The current slice. REQUIRES: the last advance() returned true
  [[nodiscard]] std::int64_t bottom() const { return bottom_; }
  [[nodiscard]] std::int64_t top() const { return top_; }
  [[nodiscard]] core::Region take_region();

  [[nodiscard]] bool left_polygons_out() const { return left_polygons_out_; }
  // An error with file, part, line and cause.
  [[nodiscard]] core::Error bad(const std::string& cause) const { return xml_->bad(cause); }

 private:
  [[nodiscard]] core::Status open();
  // Reads the next <slice>; false at the stack's end.
  [[nodiscard]] core::Result<bool> read_on();
  [[nodiscard]] core::Status check_start(const XmlEvent& stack, const std::string& id) const;
  [[nodiscard]] core::Status read_slice(const XmlEvent& slice);
  [[nodiscard]] core::Status take(const XmlEvent& event);
  [[nodiscard]] core::Status vertex(const XmlEvent& event);
  // The vertex number in an attribute.
  [[nodiscard]] core::Result<std::size_t> number(const XmlEvent& event, const char* name) const;
  [[nodiscard]] core::Status end_polygon();

  const ZipArchive& archive_;
  SlicedItem item_;
  std::size_t next_stack_ = 0;
  std::optional<XmlScanner> xml_;
  double unit_mm_ = 1;
  bool in_stack_ = false;
  std::optional<double> top_mm_;  // of the slice before, not yet shifted
  std::int64_t bottom_ = 0;
  std::int64_t top_ = 0;
  std::vector<core::Point> vertices_;
  std::vector<std::size_t> polygon_;
  ContourGatherer contours_;
  bool left_polygons_out_ = false;
};

}  // namespace host
