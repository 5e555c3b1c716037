#include "host/part/part_items.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "host/part/derived_triangles.h"

namespace host {
namespace {

using core::Result;
using core::Triangle;

class WatchedTriangles : public DerivedTriangles {
 public:
  WatchedTriangles(std::unique_ptr<TriangleSource> triangles, std::shared_ptr<PartItems> items)
      : DerivedTriangles(std::move(triangles)), items_(std::move(items)) {}

 private:
  Result<std::optional<Triangle>> derived(const Triangle& triangle) override {
    items_->add(item(), triangle);
    return std::optional<Triangle>(triangle);
  }

  std::shared_ptr<PartItems> items_;
};

// Takes the boxes together that meet, until none do.
void unite(std::vector<PartObject>& objects) {
  for (std::size_t i = 0; i < objects.size();) {
    const auto other =
        std::find_if(objects.begin() + static_cast<std::ptrdiff_t>(i) + 1, objects.end(),
                     [&](const PartObject& object) { return objects[i].box.overlaps(object.box); });
    if (other == objects.end()) {
      ++i;
      continue;
    }
    objects[i].box.add(other->box);
    objects[i].height = std::max(objects[i].height, other->height);
    objects[i].items.insert(objects[i].items.end(), other->items.begin(), other->items.end());
    objects.erase(other);
    // It may meet earlier ones now.
    i = 0;
  }
}

}  // namespace

void PartItems::add(std::size_t item, const Triangle& triangle) {
  Extent& extent = extents_[item];
  for (const core::Vertex& corner : triangle.corners) {
    extent.box.add(core::Point{corner.x, corner.y});
    extent.highest_z = std::max(extent.highest_z, corner.z);
  }
}

std::vector<PartObject> PartItems::objects(const Shift& shift, const std::string& file) const {
  std::vector<PartObject> objects;
  for (std::size_t i = 0; i < extents_.size(); ++i) {
    if (extents_[i].box.empty()) continue;
    PartObject object;
    object.title = names_[i].empty() ? file : names_[i];
    object.box = shifted(extents_[i].box, shift);
    object.height = core::Length::from_units(extents_[i].highest_z + shift.z);
    object.items = {i};
    objects.push_back(std::move(object));
  }
  unite(objects);
  if (objects.size() < 2) return {};
  for (std::size_t i = 0; i < objects.size(); ++i) {
    objects[i].name = object_name(objects[i].title, i + 1);
    std::sort(objects[i].items.begin(), objects[i].items.end());
  }
  return objects;
}

std::unique_ptr<TriangleSource> watched(std::unique_ptr<TriangleSource> triangles,
                                        std::shared_ptr<PartItems> items) {
  return std::make_unique<WatchedTriangles>(std::move(triangles), std::move(items));
}

std::string object_name(const std::string& name, std::size_t number) {
  constexpr std::size_t kBytesMax = 24;
  std::string plain = name == "-" ? "part" : std::filesystem::path(name).stem().string();
  if (plain.size() > kBytesMax) plain.resize(kBytesMax);
  const auto is_plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  for (char& c : plain) c = is_plain(c) ? c : '_';
  return fmt::format("{}_{}", plain, number);
}

}  // namespace host
