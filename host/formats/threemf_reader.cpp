#include "host/formats/threemf_reader.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/formats/format_limits.h"   // kWordBytesMax
#include "host/formats/mesh_store.h"      // MeshStore
#include "host/formats/number_text.h"     // parse_real
#include "host/formats/slice_stack.h"     // SlicedItem
#include "host/formats/text_scanner.h"    // is_blank, shown
#include "host/formats/threemf_slices.h"  // open_threemf_slices

namespace host {
namespace {

using core::Result;
using core::Status;

constexpr const char* kPath =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06|path";
constexpr const char* kResolution =
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07|meshresolution";
constexpr const char* kStackId =
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07|slicestackid";

// Extensions that a file may require. What they add is taken, or changes no shape.
constexpr std::array<std::string_view, 5> kKnownExtensions{
    "http://schemas.microsoft.com/3dmanufacturing/core/",
    "http://schemas.microsoft.com/3dmanufacturing/production/",
    "http://schemas.microsoft.com/3dmanufacturing/material/",
    "http://schemas.microsoft.com/3dmanufacturing/slice/",
    "http://schemas.microsoft.com/3dmanufacturing/triangleset"};

// The next word of a list parted by blanks; empty at its end.
std::string_view take_word(std::string_view& list) {
  while (!list.empty() && is_blank(static_cast<unsigned char>(list.front()))) list.remove_prefix(1);
  std::size_t end = 0;
  while (end < list.size() && !is_blank(static_cast<unsigned char>(list[end]))) ++end;
  const std::string_view word = list.substr(0, end);
  list.remove_prefix(end);
  return word;
}

class ThreeMfReader : public TriangleSource {
 public:
  explicit ThreeMfReader(ZipArchive archive) : archive_(std::move(archive)) {}

  [[nodiscard]] std::string format() const override { return "3MF"; }

  [[nodiscard]] Status open() {
    const Result<std::string> root = root_part();
    if (!root.ok()) return root.error();
    parts_.push_back(root.value());
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (Status read = read_part(static_cast<int>(i)); !read.ok()) return read;
    }
    if (items_.empty()) return refused("the build has no item to print; export the part again");
    for (const Item& item : items_) {
      const std::string cause =
          sliced_.contains(item.key) ? add_sliced(item) : store_.add_item(item.key, item.transform);
      if (!cause.empty()) return refused(cause);
    }
    if (!sliced_items_.empty() && sliced_items_.size() < items_.size()) {
      return refused("some items are slices, some are meshes; print them apart");
    }
    return {};
  }

  // Empty: what is to be printed are meshes.
  [[nodiscard]] const std::vector<SlicedItem>& sliced_items() const { return sliced_items_; }
  [[nodiscard]] ZipArchive take_archive() { return std::move(archive_); }

  [[nodiscard]] Result<std::optional<core::Triangle>> next() override {
    MeshStore::Next next = store_.next();
    if (!next.error.empty()) return refused(next.error);
    if (next.triangle) {
      ++facets_;
    } else if (facets_ == 0) {
      return refused("there is no triangle in what is to be printed; export the part again");
    }
    return next.triangle;
  }

 private:
  struct Item {
    MeshStore::Key key;
    Transform transform;
  };
  struct Stack {
    double bottom_mm = 0;
    std::vector<StackPlace> referred;  // empty: it has slices of its own
  };

  [[nodiscard]] core::Error refused(const std::string& cause) const {
    return {core::ErrorCode::kBadPart, archive_.name() + ": " + cause};
  }

  [[nodiscard]] Result<XmlScanner> scanner_of(const std::string& part) const {
    Result<XmlScanner::ByteSource> bytes = archive_.bytes_of(part);
    if (!bytes.ok()) return bytes.error();
    return XmlScanner(archive_.name() + " (" + part + ")", std::move(bytes).value(), false);
  }

  // The package's relationships name it.
  [[nodiscard]] Result<std::string> root_part() const {
    if (archive_.contains("_rels/.rels")) {
      Result<XmlScanner> xml = scanner_of("_rels/.rels");
      if (!xml.ok()) return xml.error();
      while (true) {
        const Result<const XmlEvent*> event = xml.value().next();
        if (!event.ok()) return event.error();
        if (event.value() == nullptr) break;
        const std::string* type = event.value()->attribute("Type");
        const std::string* target = event.value()->attribute("Target");
        if (event.value()->name == "Relationship" && type && target && type->ends_with("3dmodel")) {
          return without_slash(*target);
        }
      }
    }
    std::string usual = archive_.find_ending(".model");
    if (usual.empty()) return refused("a zip archive without a 3MF model; export 3MF or STL");
    return usual;
  }

  static std::string without_slash(const std::string& path) {
    return path.starts_with('/') ? path.substr(1) : path;
  }

  // The part's number, read some day; -1 when there are too many.
  [[nodiscard]] int part_number(const std::string& path) {
    const std::string name = without_slash(path);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (parts_[i] == name) return static_cast<int>(i);
    }
    if (parts_.size() >= static_cast<std::size_t>(kThreeMfPartsMax)) return -1;
    parts_.push_back(name);
    return static_cast<int>(parts_.size()) - 1;
  }

  [[nodiscard]] Status read_part(int part) {
    Result<XmlScanner> opened = scanner_of(parts_[static_cast<std::size_t>(part)]);
    if (!opened.ok()) return opened.error();
    XmlScanner& xml = opened.value();
    unit_mm_ = 1;
    while (true) {
      const Result<const XmlEvent*> event = xml.next();
      if (!event.ok()) return event.error();
      if (event.value() == nullptr) return {};
      if (event.value()->kind != XmlEvent::Kind::kStart) continue;
      Status taken;
      if (event.value()->space == kThreeMfCore) taken = take(*event.value(), part, xml);
      if (event.value()->space == kThreeMfSlice) taken = take_stack(*event.value(), part, xml);
      if (!taken.ok()) return taken;
    }
  }

  [[nodiscard]] Status take(const XmlEvent& event, int part, const XmlScanner& xml) {
    if (event.name == "vertex") return vertex(event, xml);
    if (event.name == "triangle") return triangle(event, xml);
    if (event.name == "model") return model(event, xml);
    if (event.name == "object") return object(event, part, xml);
    if (event.name == "component") return component(event, part, xml);
    // Only the root's build counts.
    if (event.name == "item" && part == 0) return item(event, part, xml);
    return {};
  }

  [[nodiscard]] Status model(const XmlEvent& event, const XmlScanner& xml) {
    if (const std::string* unit = event.attribute("unit")) {
      const std::optional<double> mm = threemf_unit_mm(*unit);
      if (!mm) return xml.bad("unit '" + shown(*unit) + "' is none of 3MF's; export it again");
      unit_mm_ = *mm;
    }
    const std::string* required = event.attribute("requiredextensions");
    if (required == nullptr) return {};
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
    return {};
  }

  [[nodiscard]] Status object(const XmlEvent& event, int part, const XmlScanner& xml) {
    const std::string* id = event.attribute("id");
    if (id == nullptr) return xml.bad("an object without id; export the part again");
    if (!store_.begin_object({part, *id})) {
      return xml.bad("object '" + shown(*id) + "' is there twice, or there are too many objects");
    }
    in_object_ = true;
    const std::string* resolution = event.attribute(kResolution);
    if (resolution != nullptr && *resolution == "lowres") {
      const std::string* stack = event.attribute(kStackId);
      if (stack == nullptr) return xml.bad("object '" + shown(*id) + "' has no slicestackid");
      sliced_[{part, *id}] = *stack;
    }
    const std::string* type = event.attribute("type");
    if (type != nullptr && *type != "model" && *type != "solidsupport") {
      unprintable_.insert({part, *id});
    }
    return {};
  }

  [[nodiscard]] Status vertex(const XmlEvent& event, const XmlScanner& xml) {
    PointMm point{};
    constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string* text = event.attribute(kNames[i]);
      const std::optional<double> value = text ? parse_real(*text) : std::nullopt;
      if (!value) return xml.bad("a vertex without a number for x, y or z; export the part again");
      point[i] = *value * unit_mm_;
    }
    if (!in_object_) return xml.bad("a vertex outside of an object; export the part again");
    return store_.add_vertex(point);
  }

  [[nodiscard]] Status triangle(const XmlEvent& event, const XmlScanner& xml) {
    std::array<std::uint32_t, 3> corners{};
    constexpr std::array<const char*, 3> kNames{"v1", "v2", "v3"};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string* text = event.attribute(kNames[i]);
      const std::optional<std::int64_t> index = text ? parse_integer(*text) : std::nullopt;
      const bool known =
          index && *index >= 0 && static_cast<std::uint64_t>(*index) < store_.vertices();
      if (!known) {
        return xml.bad("a triangle's corner '" + (text ? shown(*text) : std::string()) +
                       "' is no vertex of its object's " + std::to_string(store_.vertices()) +
                       "; export the part again");
      }
      corners[i] = static_cast<std::uint32_t>(*index);
    }
    return store_.add_triangle(corners);
  }

  // Twelve numbers; the translation is in the part's unit.
  [[nodiscard]] Result<Transform> transform(const XmlEvent& event, const XmlScanner& xml) const {
    Transform result;
    const std::string* text = event.attribute("transform");
    if (text == nullptr) return result;
    std::string_view list = *text;
    for (std::size_t i = 0; i < result.m.size(); ++i) {
      const std::optional<double> value = parse_real(take_word(list));
      if (!value) return xml.bad("'" + shown(*text) + "' is no transform; export the part again");
      result.m[i] = i < 9 ? *value : *value * unit_mm_;
    }
    return result;
  }

  // The object that a component or an item names.
  [[nodiscard]] Result<Item> reference(const XmlEvent& event, int part, const XmlScanner& xml) {
    const std::string* id = event.attribute("objectid");
    if (id == nullptr) return xml.bad("a reference without objectid; export the part again");
    Result<Transform> placed = transform(event, xml);
    if (!placed.ok()) return placed.error();
    const std::string* path = event.attribute(kPath);
    const int there = path == nullptr ? part : part_number(*path);
    if (there < 0) {
      return xml.bad("more than " + std::to_string(kThreeMfPartsMax) + " model parts; merge them");
    }
    return Item{{there, *id}, placed.value()};
  }

  [[nodiscard]] Status component(const XmlEvent& event, int part, const XmlScanner& xml) {
    Result<Item> read = reference(event, part, xml);
    if (!read.ok()) return read.error();
    if (!in_object_) return xml.bad("a component outside of an object; export the part again");
    if (sliced_.contains(read.value().key)) {
      return xml.bad("object '" + shown(read.value().key.second) +
                     "', which is slices, as a component: not supported; make it an item of its "
                     "own, or export its full mesh");
    }
    store_.add_component(read.value().key, read.value().transform);
    return {};
  }

  // Where slices stand; they are read when they are asked for.
  [[nodiscard]] Status take_stack(const XmlEvent& event, int part, const XmlScanner& xml) {
    if (event.name == "slicestack") {
      const std::string* id = event.attribute("id");
      const std::string* bottom = event.attribute("zbottom");
      const std::optional<double> z = bottom ? parse_real(*bottom) : 0.0;
      if (id == nullptr || !z) return xml.bad("a slicestack without id, or with no zbottom");
      if (stacks_.size() >= kMeshObjectsMax) return xml.bad("too many slicestacks; merge them");
      stack_ = &stacks_[{part, *id}];
      stack_->bottom_mm = *z * unit_mm_;
    } else if (event.name == "sliceref") {
      const std::string* id = event.attribute("slicestackid");
      const std::string* path = event.attribute("slicepath");
      if (id == nullptr || path == nullptr || stack_ == nullptr) {
        return xml.bad("a sliceref without slicestackid or slicepath; export the part again");
      }
      if (stack_->referred.size() >= kMeshObjectsMax) return xml.bad("too many references");
      stack_->referred.push_back({without_slash(*path), *id});
    }
    return {};
  }

  // Returns why it can't be printed; empty when it can.
  [[nodiscard]] std::string add_sliced(const Item& item) {
    const auto& [part, object] = item.key;
    const std::string& id = sliced_.at(item.key);
    const auto found = stacks_.find({part, id});
    if (found == stacks_.end()) return "slicestack '" + shown(id) + "' is not in the file";
    const auto& m = item.transform.m;
    if (m[2] != 0 || m[5] != 0 || m[6] != 0 || m[7] != 0 || m[8] != 1) {
      return "object '" + shown(object) +
             "' is slices, and the build tilts them or changes their height; export its full mesh";
    }
    if (sliced_items_.size() >= kSlicedItemsMax) {
      return "more than " + std::to_string(kSlicedItemsMax) + " items that are slices; merge them";
    }
    SlicedItem sliced{found->second.referred, found->second.bottom_mm, item.transform};
    if (sliced.stacks.empty())
      sliced.stacks.push_back({parts_[static_cast<std::size_t>(part)], id});
    sliced_items_.push_back(std::move(sliced));
    return {};
  }

  [[nodiscard]] Status item(const XmlEvent& event, int part, const XmlScanner& xml) {
    Result<Item> read = reference(event, part, xml);
    if (!read.ok()) return read.error();
    const std::string* printable = event.attribute("printable");
    const bool wanted = printable == nullptr || *printable != "0";
    if (!wanted || unprintable_.contains(read.value().key)) {
      if (!told_) {
        warnings_.push_back(archive_.name() + ": objects that are not to be printed were left out");
      }
      told_ = true;
      return {};
    }
    if (items_.size() >= kMeshInstancesMax) return xml.bad("too many items to build; merge them");
    items_.push_back(std::move(read).value());
    return {};
  }

  ZipArchive archive_;
  MeshStore store_;
  std::vector<std::string> parts_;  // the package's models; the root is the first
  std::vector<Item> items_;
  std::set<MeshStore::Key> unprintable_;
  std::map<MeshStore::Key, std::string> sliced_;  // objects that are slices: their stack
  std::map<MeshStore::Key, Stack> stacks_;
  Stack* stack_ = nullptr;  // that is being read
  std::vector<SlicedItem> sliced_items_;
  double unit_mm_ = 1;  // of the part that is being read
  bool in_object_ = false;
  bool told_ = false;
};

}  // namespace

Result<MeshOrLayers> open_threemf(ZipArchive archive) {
  auto reader = std::make_unique<ThreeMfReader>(std::move(archive));
  if (Status opened = reader->open(); !opened.ok()) return opened.error();
  if (reader->sliced_items().empty()) {
    return MeshOrLayers(std::unique_ptr<TriangleSource>(std::move(reader)));
  }
  std::vector<SlicedItem> items = reader->sliced_items();
  Result<std::unique_ptr<LayerReader>> layers =
      open_threemf_slices(reader->take_archive(), std::move(items));
  if (!layers.ok()) return layers.error();
  return MeshOrLayers(std::move(layers).value());
}

}  // namespace host
