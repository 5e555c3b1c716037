#include "host/formats/threemf_reader.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/formats/mesh_store.h"         // MeshStore
#include "host/formats/number_text.h"        // parse_real
#include "host/formats/slice_stack.h"        // SlicedItem
#include "host/formats/text_scanner.h"       // shown
#include "host/formats/threemf_cut.h"        // cut_items
#include "host/formats/threemf_elements.h"   // point_of
#include "host/formats/threemf_marks.h"      // gather_marks
#include "host/formats/threemf_modifiers.h"  // gather_modifiers
#include "host/formats/threemf_package.h"    // root_model, scanner_of
#include "host/formats/threemf_roles.h"      // read_roles
#include "host/formats/threemf_slices.h"     // open_threemf_slices
#include "host/formats/threemf_stacks.h"     // ThreeMfStacks

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

class ThreeMfReader : public TriangleSource {
 public:
  explicit ThreeMfReader(ZipArchive archive) : archive_(std::move(archive)) {}

  [[nodiscard]] std::string format() const override { return "3MF"; }

  [[nodiscard]] Status open() {
    const Result<std::string> root = root_model(archive_);
    if (!root.ok()) return root.error();
    Result<ThreeMfRoles> roles = read_roles(archive_);
    if (!roles.ok()) return roles.error();
    roles_ = std::move(roles).value();
    parts_.push_back(root.value());
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (Status read = read_part(static_cast<int>(i)); !read.ok()) return read;
    }
    if (Status applied = apply_roles(); !applied.ok()) return applied;
    if (items_.empty()) return refused("the build has no item to print; export the part again");
    if (Status added = add_items(); !added.ok()) return added;
    if (!sliced_items_.empty() && sliced_items_.size() < items_.size()) {
      return refused("some items are slices, some are meshes; print them apart");
    }
    return {};
  }

  [[nodiscard]] MarkCounts mark_counts() const override {
    return {roles_.enforcers, roles_.blockers, painted_};
  }

  [[nodiscard]] Result<std::unique_ptr<MarkedFacets>> marked_facets() override {
    if (!mark_counts().any()) return std::unique_ptr<MarkedFacets>();
    Result<std::unique_ptr<MarkedFacets>> marks = gather_marks(items_, store_);
    if (!marks.ok()) return refused(marks.error().message);
    if (Status added = add_items(); !added.ok()) return added.error();
    return marks;
  }

  [[nodiscard]] Result<std::vector<ModifierBody>> modifiers() override {
    if (roles_.changes.empty() || !sliced_items_.empty()) return std::vector<ModifierBody>();
    Result<std::vector<ModifierBody>> bodies = gather_modifiers(roles_.changes, items_, store_);
    if (!bodies.ok()) return refused(bodies.error().message);
    if (Status added = add_items(); !added.ok()) return added.error();
    return bodies;
  }

  [[nodiscard]] std::vector<std::string> items() const override {
    std::vector<std::string> names;
    for (const ThreeMfItem& item : items_) {
      const auto own = names_.find(item.key);
      const auto told = roles_.names.find(item.key.second);
      const bool by_slicer = item.key.first == 0 && told != roles_.names.end();
      names.push_back(by_slicer ? told->second : own != names_.end() ? own->second : "");
    }
    return names;
  }
  [[nodiscard]] std::size_t item() const override {
    const auto end = std::upper_bound(ends_.begin(), ends_.end(), store_.instance());
    return static_cast<std::size_t>(end - ends_.begin());
  }
  [[nodiscard]] Status keep_items(const std::vector<std::size_t>& items) override {
    std::vector<ThreeMfItem> kept;
    kept.reserve(items.size());
    for (const std::size_t number : items) kept.push_back(items_.at(number));
    items_ = std::move(kept);
    store_.clear_items();
    return add_items();
  }

  // True if items have negative parts: the content is booleans then, no triangles.
  [[nodiscard]] bool is_cut() const {
    return sliced_items_.empty() && std::any_of(items_.begin(), items_.end(), [&](const auto& i) {
             return store_.count(i.key, MeshRole::kNegative) > 0;
           });
  }
  // REQUIRES: is_cut(); not used afterwards
  [[nodiscard]] Result<std::unique_ptr<ShellTree>> take_tree() {
    tree_->format = format();
    tree_->name = archive_.name();
    Result<std::unique_ptr<MarkedFacets>> marks = marked_facets();
    if (!marks.ok()) return marks.error();
    if (marks.value()) marks.value()->printed = {};  // what is left of it is not known
    Result<std::vector<ModifierBody>> bodies = modifiers();
    if (!bodies.ok()) return bodies.error();
    tree_->modifiers = std::move(bodies).value();
    tree_->mark_counts = mark_counts();
    tree_->marked_facets = std::move(marks).value();
    tree_->warnings = std::move(warnings_);
    store_.clear_items();
    if (Status cut = cut_items(items_, *tree_); !cut.ok()) return cut.error();
    return std::move(tree_);
  }

  // Empty if the items are meshes.
  [[nodiscard]] const std::vector<SlicedItem>& sliced_items() const { return sliced_items_; }
  [[nodiscard]] ZipArchive take_archive() { return std::move(archive_); }

  [[nodiscard]] Result<bool> rewind() override {
    store_.clear_items();
    if (Status added = add_items(); !added.ok()) return added.error();
    facets_ = 0;
    return true;
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
  [[nodiscard]] Status add_items() {
    ends_.clear();
    for (const ThreeMfItem& item : items_) {
      const std::string cause = stacks_.contains(item.key)
                                    ? stacks_.add(item, parts_, sliced_items_)
                                    : store_.add_item(item.key, item.transform);
      if (!cause.empty()) return refused(cause);
      ends_.push_back(store_.instances());
    }
    return {};
  }

  [[nodiscard]] core::Error refused(const std::string& cause) const {
    return {core::ErrorCode::kBadPart, archive_.name() + ": " + cause};
  }

  // The part's number; the part is read later. -1 if there are too many.
  [[nodiscard]] int part_number(const std::string& path) {
    const std::string name = without_slash(path);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (entry_key(parts_[i]) == entry_key(name)) return static_cast<int>(i);
    }
    if (parts_.size() >= static_cast<std::size_t>(kThreeMfPartsMax)) return -1;
    parts_.push_back(name);
    return static_cast<int>(parts_.size()) - 1;
  }

  [[nodiscard]] Status read_part(int part) {
    Result<XmlScanner> opened = scanner_of(archive_, parts_[static_cast<std::size_t>(part)]);
    if (!opened.ok()) return opened.error();
    XmlScanner& xml = opened.value();
    xml.expect_lists({"vertices", "triangles"});
    unit_mm_ = 1;
    while (true) {
      const Result<const XmlEvent*> event = xml.next();
      if (!event.ok()) return event.error();
      if (event.value() == nullptr) return {};
      if (event.value()->kind != XmlEvent::Kind::kStart) continue;
      Status taken;
      if (event.value()->space == kThreeMfCore) taken = take(*event.value(), part, xml);
      if (event.value()->space == kThreeMfSlice) {
        taken = stacks_.take(*event.value(), part, unit_mm_, xml);
      }
      if (event.value()->name == "volume") taken = take_volume(*event.value(), xml);
      if (!taken.ok()) return taken;
    }
  }

  [[nodiscard]] Status take(const XmlEvent& event, int part, const XmlScanner& xml) {
    if (event.name == "vertex") return vertex(event, xml);
    if (event.name == "triangle") return triangle(event, xml);
    if (event.name == "model") {
      const Result<double> unit = unit_of(event, xml);
      if (unit.ok()) unit_mm_ = unit.value();
      return unit.ok() ? Status() : unit.error();
    }
    if (event.name == "object") return object(event, part, xml);
    if (event.name == "component") return component(event, part, xml);
    // Only the root's build counts.
    if (event.name == "item" && part == 0) return item(event, part, xml);
    return {};
  }

  [[nodiscard]] Status object(const XmlEvent& event, int part, const XmlScanner& xml) {
    const std::string* id = event.attribute("id");
    if (id == nullptr) return xml.bad("an object without id; export the part again");
    if (!store_.start_object({part, *id})) {
      return xml.bad("object '" + shown(*id) + "' is there twice, or there are too many objects");
    }
    in_object_ = true;
    object_ = {part, *id};
    if (const std::string* name = event.attribute("name")) names_[object_] = *name;
    const std::string* resolution = event.attribute(kResolution);
    if (resolution != nullptr && *resolution == "lowres") {
      const std::string* stack = event.attribute(kStackId);
      if (stack == nullptr) return xml.bad("object '" + shown(*id) + "' has no slicestackid");
      stacks_.note(object_, *stack);
    }
    const std::string* type = event.attribute("type");
    if (type != nullptr && *type != "model" && *type != "solidsupport") {
      unprintable_.insert({part, *id});
    }
    return {};
  }

  [[nodiscard]] Status vertex(const XmlEvent& event, const XmlScanner& xml) {
    const Result<PointMm> point = point_of(event, xml, unit_mm_);
    if (!point.ok()) return point.error();
    if (!in_object_) return xml.bad("a vertex outside of an object; export the part again");
    return store_.add_vertex(point.value());
  }

  [[nodiscard]] Status triangle(const XmlEvent& event, const XmlScanner& xml) {
    const auto corners = corners_of(event, xml, store_.vertices());
    if (!corners.ok()) return corners.error();
    if (Status added = store_.add_triangle(corners.value()); !added.ok()) return added;
    if (event.attributes.size() == corners.value().size()) return {};
    other_paint_ = other_paint_ || has_other_paint(event);
    const std::string_view paint = support_paint_of(event);
    if (paint.empty()) return {};
    ++painted_;
    return store_.paint(paint);
  }

  // The object that a component or an item refers to.
  [[nodiscard]] Result<ThreeMfItem> reference(const XmlEvent& event, int part,
                                              const XmlScanner& xml) {
    const std::string* id = event.attribute("objectid");
    if (id == nullptr) return xml.bad("a reference without objectid; export the part again");
    Result<Transform> placed = transform_of(event, xml, unit_mm_);
    if (!placed.ok()) return placed.error();
    const std::string* path = event.attribute(kPath);
    const int there = path == nullptr ? part : part_number(*path);
    if (there < 0) {
      return xml.bad("more than " + std::to_string(kThreeMfPartsMax) + " model parts; merge them");
    }
    return ThreeMfItem{{there, *id}, placed.value()};
  }

  [[nodiscard]] Status component(const XmlEvent& event, int part, const XmlScanner& xml) {
    Result<ThreeMfItem> read = reference(event, part, xml);
    if (!read.ok()) return read.error();
    if (!in_object_) return xml.bad("a component outside of an object; export the part again");
    if (stacks_.contains(read.value().key)) {
      return xml.bad("object '" + shown(read.value().key.second) +
                     "', which is slices, as a component: not supported; make it an item of its "
                     "own, or export its full mesh");
    }
    const auto role = roles_.parts.find({object_.second, read.value().key.second});
    const bool marked = object_.first == 0 && role != roles_.parts.end();
    store_.add_component(read.value().key, read.value().transform, false,
                         marked ? role->second : MeshRole::kSolid);
    return {};
  }

  // Slic3r's own <volume ts te modifier>, after the triangles that it refers to.
  [[nodiscard]] Status take_volume(const XmlEvent& event, const XmlScanner& xml) {
    const std::string* modifier = event.attribute("modifier");
    const std::string *first = event.attribute("ts"), *last = event.attribute("te");
    if (modifier == nullptr || *modifier != "1" || !in_object_) return {};
    const std::int64_t from = first == nullptr ? -1 : parse_integer(*first).value_or(-1);
    const std::int64_t to = last == nullptr ? -1 : parse_integer(*last).value_or(-1);
    if (from < 0 || to < from) {
      return xml.bad("a volume without a first and a last triangle; export the part again");
    }
    std::vector<RoleRange>& ranges = own_volumes_[object_];
    if (ranges.size() >= kMeshObjectsMax) return xml.bad("too many volumes; merge them");
    ranges.push_back(
        {static_cast<std::size_t>(from), static_cast<std::size_t>(to), MeshRole::kLeftOut});
    ++roles_.modifiers;
    return {};
  }

  // REQUIRES: all triangles have been read.
  [[nodiscard]] Status apply_roles() {
    for (const auto& [object, ranges] : roles_.volumes) own_volumes_[{0, object}] = ranges;
    for (const auto& [place, role] : roles_.parts) {
      const MeshStore::Key key{0, place.first};
      const std::size_t count = store_.triangles(key);
      if (place.first == place.second && count > 0) own_volumes_[key] = {{0, count - 1, role}};
    }
    for (auto& [key, ranges] : own_volumes_) {
      const std::size_t count = store_.triangles(key);
      if (!in_order(ranges)) {
        return refused("object '" + shown(key.second) +
                       "' has volumes that share triangles; export the part again");
      }
      for (const RoleRange& range : ranges) {
        if (range.first >= count) continue;
        store_.set_role(key, range.first, std::min(range.last + 1, count) - range.first,
                        range.role);
      }
    }
    for (const std::string& text : roles_.left_out()) warn(text);
    if (other_paint_) warn("seams, colours or textures that are painted on are not used");
    return {};
  }

  void warn(const std::string& text) { warnings_.push_back(archive_.name() + ": " + text); }

  [[nodiscard]] Status item(const XmlEvent& event, int part, const XmlScanner& xml) {
    Result<ThreeMfItem> read = reference(event, part, xml);
    if (!read.ok()) return read.error();
    const std::string* printable = event.attribute("printable");
    const bool wanted = printable == nullptr || *printable != "0";
    if (!wanted || unprintable_.contains(read.value().key)) {
      if (!told_) warn("objects that are not to be printed were left out");
      told_ = true;
      return {};
    }
    if (items_.size() >= kMeshInstancesMax) return xml.bad("too many items to build; merge them");
    items_.push_back(std::move(read).value());
    return {};
  }

  ZipArchive archive_;
  std::unique_ptr<ShellTree> tree_ = std::make_unique<ShellTree>();
  MeshStore& store_ = tree_->store;
  std::vector<std::string> parts_;  // the package's models; the root is the first
  std::vector<ThreeMfItem> items_;
  std::set<MeshStore::Key> unprintable_;
  std::vector<std::size_t> ends_;                // of each item's instances in the store
  std::map<MeshStore::Key, std::string> names_;  // of objects
  ThreeMfStacks stacks_;
  std::vector<SlicedItem> sliced_items_;
  double unit_mm_ = 1;  // of the part that is being read
  bool in_object_ = false;
  MeshStore::Key object_;  // the one that was started last
  bool told_ = false;
  bool other_paint_ = false;
  std::int64_t painted_ = 0;  // facets, for supports
  ThreeMfRoles roles_;
  std::map<MeshStore::Key, std::vector<RoleRange>> own_volumes_;
};

}  // namespace

Result<PartContent> open_threemf(ZipArchive archive) {
  auto reader = std::make_unique<ThreeMfReader>(std::move(archive));
  if (Status opened = reader->open(); !opened.ok()) return opened.error();
  if (reader->is_cut()) {
    Result<std::unique_ptr<ShellTree>> tree = reader->take_tree();
    if (!tree.ok()) return tree.error();
    return PartContent(std::move(tree).value());
  }
  if (reader->sliced_items().empty()) {
    return PartContent(std::unique_ptr<TriangleSource>(std::move(reader)));
  }
  std::vector<SlicedItem> items = reader->sliced_items();
  Result<std::unique_ptr<LayerReader>> layers =
      open_threemf_slices(reader->take_archive(), std::move(items));
  if (!layers.ok()) return layers.error();
  return PartContent(std::move(layers).value());
}

}  // namespace host
