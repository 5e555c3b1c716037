#include "host/formats/cli_writer.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <iterator>
#include <span>

#include "host/formats/number_text.h"  // append_real_mm

namespace host {
namespace {

using core::Point;
using core::Ring;

constexpr int kWallLabel = 1, kInsideLabel = 2;

// In the order of core::RoadKind.
constexpr std::array<const char*, core::kRoadKindCount> kRoadLabels{
    "skirt",     "outer perimeter",
    "perimeter", "solid",
    "rest",      "loose",
    "brim",      "overhang perimeter",
    "top solid", "bottom solid",
    "bridge",    "bridge over loose",
    "ironing",   "raft",
    "support",   "support interface"};

int direction_of(const Ring& ring) { return core::doubled_area_units(ring) > 0 ? 1 : 0; }

void append_header(const char* kind, const char* unit, const LayerFileHead& head,
                   std::span<const char* const> labels, std::string& into) {
  const auto out = std::back_inserter(into);
  fmt::format_to(out, "$$HEADERSTART\n$${}\n$$UNITS/{}\n$$VERSION/200\n", kind, unit);
  if (head.layers > 0) fmt::format_to(out, "$$LAYERS/{}\n", head.layers);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    fmt::format_to(out, "$$LABEL/{},\"{}\"\n", i + 1, labels[i]);
  }
  into += "$$HEADEREND";
}

std::span<const char* const> contour_labels(const LayerFileHead& head) {
  static constexpr std::array<const char*, 2> kWalls{"solid", "loose"};
  static constexpr std::array<const char*, 1> kSlices{"part"};
  if (head.contents == LayerContents::kSlices) return kSlices;
  return kWalls;
}

void append_point(Point point, std::string& into) {
  into += ',';
  append_real_mm(point.x, into);
  into += ',';
  append_real_mm(point.y, into);
}

void append_layer(const core::Slice& slice, std::string& into) {
  into += "$$LAYER/";
  append_real_mm(slice.top().units(), into);
  into += '\n';
}

// The common part of both kinds of contour files.
class ContourWriter : public LayerWriter {
 public:
  explicit ContourWriter(const LayerFileHead& head) : head_(head) {}

 protected:
  template <typename Write>
  void for_rings(const core::SplitLayer& layer, Write write) const {
    if (head_.contents == LayerContents::kSlices) {
      for (const Ring& ring : layer.slice.region.rings()) write(kWallLabel, ring);
      return;
    }
    for (const Ring& ring : layer.solid.rings()) write(kWallLabel, ring);
    for (const Ring& ring : layer.loose.rings()) write(kInsideLabel, ring);
  }

  LayerFileHead head_;
};

class TextWriter : public ContourWriter {
 public:
  using ContourWriter::ContourWriter;

  void begin(std::string& into) override {
    append_header("ASCII", "1.0", head_, contour_labels(head_), into);
    into += "\n$$GEOMETRYSTART\n";
  }

  void layer(const core::SplitLayer& layer, const std::vector<core::Road>&,
             std::string& into) override {
    append_layer(layer.slice, into);
    for_rings(layer, [&into](int label, const Ring& ring) {
      // A closed contour repeats its first point at the end.
      fmt::format_to(std::back_inserter(into), "$$POLYLINE/{},{},{}", label, direction_of(ring),
                     ring.size() + 1);
      for (const Point point : ring) append_point(point, into);
      append_point(ring.front(), into);
      into += '\n';
    });
  }

  void end(std::string& into) override { into += "$$GEOMETRYEND\n"; }
};

class BinaryWriter : public ContourWriter {
 public:
  using ContourWriter::ContourWriter;

  // The layers follow the head without a line end.
  void begin(std::string& into) override {
    append_header("BINARY", "0.0001", head_, contour_labels(head_), into);
  }

  void layer(const core::SplitLayer& layer, const std::vector<core::Road>&,
             std::string& into) override {
    constexpr unsigned kLayer = 127, kPolyline = 130;
    append_bytes(kLayer, 2, into);
    append_float(layer.slice.top().units(), into);
    for_rings(layer, [&into](int label, const Ring& ring) {
      append_bytes(kPolyline, 2, into);
      append_bytes(static_cast<std::uint32_t>(label), 4, into);
      append_bytes(static_cast<std::uint32_t>(direction_of(ring)), 4, into);
      append_bytes(static_cast<std::uint32_t>(ring.size() + 1), 4, into);
      const auto append = [&into](Point point) {
        append_float(point.x, into);
        append_float(point.y, into);
      };
      for (const Point point : ring) append(point);
      append(ring.front());
    });
  }

  void end(std::string&) override {}

 private:
  static void append_bytes(std::uint32_t number, int bytes, std::string& into) {
    for (int i = 0; i < bytes; ++i) into += static_cast<char>(number >> (8 * i) & 0xFF);
  }

  static void append_float(std::int64_t units, std::string& into) {
    append_bytes(std::bit_cast<std::uint32_t>(static_cast<float>(units)), 4, into);
  }
};

class RoadWriter : public LayerWriter {
 public:
  explicit RoadWriter(const LayerFileHead& head) : head_(head) {}

  [[nodiscard]] bool wants_roads() const override { return true; }

  void begin(std::string& into) override {
    append_header("ASCII", "1.0", head_, kRoadLabels, into);
    into += "\n$$GEOMETRYSTART\n";
  }

  void layer(const core::SplitLayer& layer, const std::vector<core::Road>& roads,
             std::string& into) override {
    append_layer(layer.slice, into);
    for (const core::Road& road : roads) {
      const std::vector<Point>& points = road.points;
      fmt::format_to(std::back_inserter(into), "$$HATCHES/{},{}", static_cast<int>(road.kind) + 1,
                     points.size() - (road.closed ? 0 : 1));
      for (std::size_t i = 1; i < points.size(); ++i) {
        append_point(points[i - 1], into);
        append_point(points[i], into);
      }
      if (road.closed) {
        append_point(points.back(), into);
        append_point(points.front(), into);
      }
      into += '\n';
    }
  }

  void end(std::string& into) override { into += "$$GEOMETRYEND\n"; }

 private:
  LayerFileHead head_;
};

}  // namespace

std::unique_ptr<LayerWriter> cli_writer(CliKind kind, const LayerFileHead& head) {
  switch (kind) {
    case CliKind::kBinary:
      return std::make_unique<BinaryWriter>(head);
    case CliKind::kRoads:
      return std::make_unique<RoadWriter>(head);
    case CliKind::kText:
      break;
  }
  return std::make_unique<TextWriter>(head);
}

}  // namespace host
