#include "host/formats/amf_reader.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "host/formats/format_limits.h"  // kWordBytesMax
#include "host/formats/mesh_store.h"     // MeshStore
#include "host/formats/number_text.h"    // parse_real
#include "host/formats/part_kind.h"      // part_kind_of
#include "host/formats/text_scanner.h"   // is_blank, shown
#include "host/system/text.h"            // lower_case, trimmed

namespace host {
namespace {

using core::Result;
using core::Status;

struct Unit {
  const char* name;
  double mm;
};
// Those of the standard, then what else is written for them; in any case.
constexpr std::array kUnits{Unit{"millimeter", 1}, Unit{"inch", 25.4},       Unit{"feet", 304.8},
                            Unit{"meter", 1'000},  Unit{"micron", 0.001},    Unit{"millimetre", 1},
                            Unit{"mm", 1},         Unit{"centimeter", 10},   Unit{"centimetre", 10},
                            Unit{"cm", 10},        Unit{"inches", 25.4},     Unit{"in", 25.4},
                            Unit{"foot", 304.8},   Unit{"ft", 304.8},        Unit{"metre", 1'000},
                            Unit{"m", 1'000},      Unit{"micrometer", 0.001}};

constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
constexpr std::array<const char*, 3> kCorners{"v1", "v2", "v3"};
constexpr std::array<const char*, 6> kPlaces{"deltax", "deltay", "deltaz", "rx", "ry", "rz"};

// Rotations about x, y and z, in this order, then the translation.
Transform placed(const std::array<double, 6>& places, double unit_mm) {
  Transform all;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double angle = places[3 + axis] * std::numbers::pi / 180;
    if (angle == 0) continue;
    const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
    Transform turn;
    turn.m[3 * a + a] = turn.m[3 * b + b] = std::cos(angle);
    turn.m[3 * a + b] = std::sin(angle);
    turn.m[3 * b + a] = -std::sin(angle);
    all = all.then(turn);
  }
  for (std::size_t i = 0; i < 3; ++i) all.m[9 + i] = places[i] * unit_mm;
  return all;
}

class AmfReader : public TriangleSource {
 public:
  AmfReader(std::string name, XmlScanner::ByteSource bytes)
      : name_(std::move(name)), xml_(name_, std::move(bytes), true) {}

  [[nodiscard]] std::string format() const override { return "AMF"; }

  [[nodiscard]] Status open() {
    while (true) {
      const Result<const XmlEvent*> event = xml_.next();
      if (!event.ok()) return event.error();
      if (event.value() == nullptr) break;
      Status taken;
      switch (event.value()->kind) {
        case XmlEvent::Kind::kText:
          if (text_.size() < kWordBytesMax) text_ += event.value()->name;
          break;
        case XmlEvent::Kind::kStart:
          text_.clear();
          taken = start(*event.value());
          break;
        case XmlEvent::Kind::kEnd:
          taken = end(event.value()->name);
          text_.clear();
          break;
      }
      if (!taken.ok()) return taken;
    }
    return place();
  }

  [[nodiscard]] Result<bool> rewind() override {
    store_.clear_items();
    if (Status placed = place(); !placed.ok()) return placed.error();
    facets_ = 0;
    return true;
  }

  [[nodiscard]] Result<std::optional<core::Triangle>> next() override {
    MeshStore::Next next = store_.next();
    if (!next.error.empty()) return refused(next.error);
    if (next.triangle) {
      ++facets_;
    } else if (facets_ == 0) {
      return refused("there is no triangle in the file; export the part again");
    }
    return next.triangle;
  }

 private:
  [[nodiscard]] core::Error refused(const std::string& cause) const {
    return {core::ErrorCode::kBadPart, name_ + ": " + cause};
  }

  [[nodiscard]] Status place() {
    const std::vector<MeshStore::Key>& wanted =
        constellations_.empty() ? objects_ : constellations_;
    for (const MeshStore::Key& key : wanted) {
      if (held_.contains(key)) continue;
      const std::string cause = store_.add_item(key, {});
      if (!cause.empty()) return refused(cause);
    }
    return {};
  }

  [[nodiscard]] Status start(const XmlEvent& event) {
    if (event.name == "amf") {
      const std::string* unit = event.attribute("unit");
      if (unit == nullptr) return {};
      const std::string name = lower_case(trimmed(*unit));
      if (name.empty()) return {};
      for (const Unit& one : kUnits) {
        if (name != one.name && name != std::string(one.name) + "s") continue;
        unit_mm_ = one.mm;
        return {};
      }
      return xml_.bad("unit '" + shown(*unit) + "' is none of AMF's; export the part again");
    }
    if (event.name == "object" || event.name == "constellation") {
      const std::string* id = event.attribute("id");
      if (id == nullptr) return xml_.bad(event.name + " without id; export the part again");
      const MeshStore::Key key{0, *id};
      if (!store_.start_object(key)) {
        return xml_.bad("object '" + shown(*id) + "' is there twice, or there are too many");
      }
      (event.name == "object" ? objects_ : constellations_).push_back(key);
    } else if (event.name == "instance") {
      const std::string* id = event.attribute("objectid");
      if (id == nullptr) return xml_.bad("an instance without objectid; export the part again");
      instance_ = *id;
      places_ = {};
    } else if (event.name == "volume") {
      kind_ = PartKind::kPlastic;
      volume_start_ = objects_.empty() ? 0 : store_.triangles(objects_.back());
      in_volume_ = !objects_.empty() && constellations_.empty();
    } else if (event.name == "metadata") {
      const std::string* type = event.attribute("type");
      metadata_ = type == nullptr ? "" : *type;
    } else if (event.name == "edge" || event.name == "normal") {
      if (!std::exchange(curved_, true)) {
        warnings_.push_back(name_ + ": curved triangles were taken flat");
      }
    }
    return {};
  }

  // Where `name` is one of these, the number that stood in it.
  template <std::size_t N>
  [[nodiscard]] Result<bool> number(const std::string& name,
                                    const std::array<const char*, N>& names,
                                    std::array<double, N>& into) {
    for (std::size_t i = 0; i < N; ++i) {
      if (name != names[i]) continue;
      const std::optional<double> value = parse_real(trimmed(text_));
      if (!value) return xml_.bad("'" + shown(text_) + "' in <" + name + "> is no number");
      into[i] = *value;
      return true;
    }
    return false;
  }

  [[nodiscard]] Status end(const std::string& name) {
    if (name == "coordinates") {
      if (objects_.empty() || !constellations_.empty()) {
        return xml_.bad("a vertex outside of an object; export the part again");
      }
      for (double& coordinate : point_) coordinate *= unit_mm_;
      return store_.add_vertex(point_);
    }
    if (name == "triangle") return triangle();
    if (name == "metadata" && in_volume_) metadata();
    if (name == "volume" && in_volume_) return end_volume();
    if (name == "instance") {
      if (constellations_.empty()) return xml_.bad("an instance outside of a constellation");
      const MeshStore::Key key{0, instance_};
      held_.insert(key);
      store_.add_component(key, placed(places_, unit_mm_));
      return {};
    }
    Result<bool> taken = number(name, kAxes, point_);
    if (taken.ok() && !taken.value()) taken = number(name, kCorners, corners_);
    if (taken.ok() && !taken.value()) taken = number(name, kPlaces, places_);
    return taken.ok() ? Status() : taken.error();
  }

  // Slic3r's and PrusaSlicer's, within a volume.
  void metadata() {
    if (metadata_ == "slic3r.volume_type") kind_ = part_kind_of(text_);
    const bool old_modifier = metadata_ == "slic3r.modifier" && trimmed(text_) == "1";
    if (old_modifier && kind_ == PartKind::kPlastic) kind_ = PartKind::kModifier;
  }

  [[nodiscard]] Status end_volume() {
    in_volume_ = false;
    if (kind_ == PartKind::kPlastic || kind_ == PartKind::kUnknown) return {};
    if (kind_ == PartKind::kNegative) {
      return xml_.bad("a negative part, which can't be read from AMF; export 3MF");
    }
    const MeshStore::Key& key = objects_.back();
    store_.set_role(key, volume_start_, store_.triangles(key) - volume_start_, MeshRole::kLeftOut);
    if (!std::exchange(left_out_, true)) {
      warnings_.push_back(name_ +
                          ": modifiers and marks for supports left out: no plastic, and their "
                          "settings are not used");
    }
    return {};
  }

  [[nodiscard]] Status triangle() {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double index = corners_[i];
      const bool known = index >= 0 && index < static_cast<double>(store_.vertices()) &&
                         index == std::floor(index);
      if (!known) {
        return xml_.bad("a triangle's corner " + number_text(index) + " is no vertex of its " +
                        "object's " + std::to_string(store_.vertices()) +
                        "; export the part again");
      }
      corners[i] = static_cast<std::uint32_t>(index);
    }
    return store_.add_triangle(corners);
  }

  std::string name_;
  XmlScanner xml_;
  MeshStore store_;
  double unit_mm_ = 1;
  std::string text_;  // of the innermost element so far
  PointMm point_{};
  std::array<double, 3> corners_{};
  std::array<double, 6> places_{};
  std::string instance_;
  std::vector<MeshStore::Key> objects_;
  std::vector<MeshStore::Key> constellations_;
  std::set<MeshStore::Key> held_;  // by a constellation
  bool curved_ = false;
  // Of the volume that is being read.
  bool in_volume_ = false;
  std::string metadata_;
  PartKind kind_ = PartKind::kPlastic;
  std::size_t volume_start_ = 0;
  bool left_out_ = false;
};

}  // namespace

Result<std::unique_ptr<TriangleSource>> open_amf(std::string name, XmlScanner::ByteSource bytes) {
  auto reader = std::make_unique<AmfReader>(std::move(name), std::move(bytes));
  if (Status opened = reader->open(); !opened.ok()) return opened.error();
  return std::unique_ptr<TriangleSource>(std::move(reader));
}

}  // namespace host
