#include "host/formats/threemf_reader.h"

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/formats/format_limits.h"  // kWordBytesMax
#include "host/formats/mesh_store.h"     // MeshStore
#include "host/formats/number_text.h"    // parse_real
#include "host/formats/text_scanner.h"   // is_blank, shown

namespace host {
namespace {

using core::Result;
using core::Status;

constexpr const char* kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr const char* kPath =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06|path";
constexpr const char* kResolution =
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07|meshresolution";

// Extensions that a file may require. What they add is taken, or changes no shape.
constexpr std::array<std::string_view, 5> kKnownExtensions{
    "http://schemas.microsoft.com/3dmanufacturing/core/",
    "http://schemas.microsoft.com/3dmanufacturing/production/",
    "http://schemas.microsoft.com/3dmanufacturing/material/",
    "http://schemas.microsoft.com/3dmanufacturing/slice/",
    "http://schemas.microsoft.com/3dmanufacturing/triangleset"};

struct Unit {
  std::string_view name;
  double mm;
};
constexpr std::array<Unit, 6> kUnits{Unit{"micron", 0.001},  Unit{"millimeter", 1},
                                     Unit{"centimeter", 10}, Unit{"inch", 25.4},
                                     Unit{"foot", 304.8},    Unit{"meter", 1'000}};

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
    for (const Item& item : items_) {
      const std::string cause = store_.add_item(item.key, item.transform);
      if (!cause.empty()) return refused(cause);
    }
    if (items_.empty()) return refused("the build has no item to print; export the part again");
    return {};
  }

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
      if (event.value()->kind != XmlEvent::Kind::kStart || event.value()->space != kCore) continue;
      if (Status taken = take(*event.value(), part, xml); !taken.ok()) return taken;
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
      bool known = false;
      for (const Unit& one : kUnits) {
        if (*unit != one.name) continue;
        unit_mm_ = one.mm;
        known = true;
      }
      if (!known) return xml.bad("unit '" + shown(*unit) + "' is none of 3MF's; export it again");
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
      return xml.bad("object '" + shown(*id) +
                     "' is given as slices (meshresolution lowres), which is not supported; export "
                     "its full mesh");
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
    store_.add_component(read.value().key, read.value().transform);
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
  double unit_mm_ = 1;  // of the part that is being read
  bool in_object_ = false;
  bool told_ = false;
};

}  // namespace

Result<std::unique_ptr<TriangleSource>> open_threemf(ZipArchive archive) {
  auto reader = std::make_unique<ThreeMfReader>(std::move(archive));
  if (Status opened = reader->open(); !opened.ok()) return opened.error();
  return std::unique_ptr<TriangleSource>(std::move(reader));
}

}  // namespace host
