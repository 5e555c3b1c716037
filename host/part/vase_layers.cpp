#include "host/part/vase_layers.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "core/walls/spiral_vase.h"

namespace host {
namespace {

class VaseLayers : public LayerSource {
 public:
  VaseLayers(std::unique_ptr<LayerSource> layers, core::Settings settings, std::string part,
             WarningBox& warnings)
      : layers_(std::move(layers)),
        settings_(std::move(settings)),
        part_(std::move(part)),
        warnings_(warnings) {}

  core::Result<std::optional<core::Slice>> next() override {
    core::Result<std::optional<core::Slice>> read = layers_->next();
    if (!read.ok() || !read.value()) return read;
    core::Slice slice = *std::move(read).value();
    if (!core::in_vase(slice, settings_)) return {std::move(slice)};
    const std::size_t contours = slice.region.rings().size();
    if (contours < 2) return {std::move(slice)};
    if (!std::exchange(told_, true)) {
      warnings_.put(
          fmt::format("{}: the part's layer {} has {} contours; above the floor, spiral_vase lays "
                      "the largest alone",
                      part_, slice.index + 1, contours));
    }
    slice.region = core::largest_contour(slice.region);
    return {std::move(slice)};
  }

 private:
  std::unique_ptr<LayerSource> layers_;
  core::Settings settings_;
  std::string part_;
  WarningBox& warnings_;
  bool told_ = false;
};

}  // namespace

std::unique_ptr<LayerSource> vase_layers(std::unique_ptr<LayerSource> layers,
                                         const core::Settings& settings, const std::string& part,
                                         WarningBox& warnings) {
  if (!settings.spiral_vase) return layers;
  return std::make_unique<VaseLayers>(std::move(layers), settings, part, warnings);
}

}  // namespace host
