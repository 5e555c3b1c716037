#include "host/formats/cli_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/units.h"                     // Length
#include "host/formats/cli_geometry.h"      // CliGeometry
#include "host/formats/cli_header.h"        // read_cli_header
#include "host/formats/contour_gatherer.h"  // ContourGatherer
#include "host/formats/format_limits.h"     // kPlaneMaxMm
#include "host/formats/number_text.h"       // append_mm

namespace host {
namespace {

using core::Length;
using core::Result;
using core::Slice;

std::string height_text(std::int64_t z_units) {
  std::string text;
  append_mm(z_units, text);
  return text + " mm";
}

class CliReader : public LayerReader {
 public:
  explicit CliReader(InputFile file) : text_(std::move(file)) {}

  [[nodiscard]] core::Status open() {
    Result<CliHeader> header = read_cli_header(text_);
    if (!header.ok()) return header.error();
    binary_ = header.value().binary;
    layers_promised_ = header.value().layers;
    if (header.value().dimension_mm) promise_box(*header.value().dimension_mm);
    geometry_ = binary_ ? cli_binary_geometry(text_, header.value())
                        : cli_text_geometry(text_, header.value());
    return {};
  }

  [[nodiscard]] std::string format() const override { return binary_ ? "binary CLI" : "ASCII CLI"; }

  [[nodiscard]] Result<std::optional<Slice>> next() override {
    while (true) {
      if (!z_) {
        Result<std::optional<std::int64_t>> first = gather();
        if (!first.ok()) return first.error();
        if (!first.value()) return std::optional<Slice>();
        z_ = first.value();
      }
      const Result<std::optional<std::int64_t>> next_z = gather();
      if (!next_z.ok()) return next_z.error();
      core::Region region = contours_.take(core::FillRule::kPositive);
      const std::int64_t z = *std::exchange(z_, next_z.value());
      if (!bottom_ && region.empty() && z_) {
        bottom_ = z;
        continue;
      }
      if (!bottom_) bottom_ = first_bottom(z);
      if (z <= *bottom_) {
        return geometry_->bad("the layer at " + height_text(z) + " does not lie above " +
                              height_text(*bottom_) + "; export the file again");
      }
      Slice slice;
      slice.index = index_++;
      slice.bottom = Length::from_units(*bottom_);
      slice.height = Length::from_units(z - *bottom_);
      slice.region = std::move(region);
      bottom_ = z;
      return std::optional<Slice>(std::move(slice));
    }
  }

 private:
  // Reads contours up to the next layer with another height. Returns that height; nullopt at the
  // end.
  [[nodiscard]] Result<std::optional<std::int64_t>> gather() {
    while (!ended_) {
      const Result<CliCommand> command = geometry_->next(contours_);
      if (!command.ok()) return command.error();
      switch (command.value().kind) {
        case CliCommand::Kind::kLayer:
          if (z_ != command.value().z_units) return std::optional(command.value().z_units);
          break;
        case CliCommand::Kind::kContour:
          if (!z_) return geometry_->bad("a polyline before the first layer; export it again");
          break;
        case CliCommand::Kind::kOpen:
          if (open_lines_++ == 0) warn(text_.name() + ": open polylines were left out");
          break;
        case CliCommand::Kind::kHatches:
          if (hatches_++ == 0) warn(text_.name() + ": hatches were left out");
          break;
        case CliCommand::Kind::kEnd:
          ended_ = true;
          break;
      }
    }
    return std::optional<std::int64_t>();
  }

  // Bottom of the first layer if it has contours; z_ is the second's upper face.
  [[nodiscard]] std::int64_t first_bottom(std::int64_t z) const {
    if (!z_) return std::min<std::int64_t>(z, 0);
    const std::int64_t second = *z_ - z;
    return z > 0 && z <= second * kFirstLayersMax ? 0 : z - second;
  }

  void promise_box(const std::array<double, 6>& mm) {
    core::Box box;
    for (const std::size_t corner : {std::size_t{0}, std::size_t{3}}) {
      const double x = mm[corner], y = mm[corner + 1];
      if (std::abs(x) > kPlaneMaxMm || std::abs(y) > kPlaneMaxMm) return;
      box.add(core::Point{static_cast<std::int32_t>(Length::from_mm(x).units()),
                          static_cast<std::int32_t>(Length::from_mm(y).units())});
    }
    box_promised_ = box;
  }

  TextScanner text_;
  bool binary_ = false;
  std::unique_ptr<CliGeometry> geometry_;
  ContourGatherer contours_;
  std::optional<std::int64_t> z_;       // of the layer that is being read
  std::optional<std::int64_t> bottom_;  // of that layer, if one lies below
  core::LayerIndex index_ = 0;
  bool ended_ = false;
  std::int64_t open_lines_ = 0;
  std::int64_t hatches_ = 0;
};

}  // namespace

Result<std::unique_ptr<LayerReader>> open_cli(InputFile file) {
  auto reader = std::make_unique<CliReader>(std::move(file));
  if (core::Status opened = reader->open(); !opened.ok()) return opened.error();
  return std::unique_ptr<LayerReader>(std::move(reader));
}

}  // namespace host
