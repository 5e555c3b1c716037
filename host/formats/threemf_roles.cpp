#include "host/formats/threemf_roles.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "host/formats/number_text.h"   // parse_integer
#include "host/formats/part_kind.h"     // part_kind_of
#include "host/formats/text_scanner.h"  // shown
#include "host/formats/xml_scanner.h"   // XmlScanner

namespace host {
namespace {

using core::Result;
using core::Status;

std::string counted(std::int64_t count, const std::string& one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

MeshRole role_of(PartKind kind) {
  switch (kind) {
    case PartKind::kNegative:
      return MeshRole::kNegative;
    case PartKind::kSupportEnforcer:
      return MeshRole::kEnforcer;
    case PartKind::kSupportBlocker:
      return MeshRole::kBlocker;
    case PartKind::kPlastic:
    case PartKind::kUnknown:
      return MeshRole::kSolid;
    case PartKind::kModifier:
      break;
  }
  return MeshRole::kLeftOut;
}

// Settings of one body that are kept.
constexpr std::size_t kBodySettingsMax = 200;

// Metadata that tells what the body is, where it comes from, or that the first extruder prints it.
bool is_no_setting(std::string_view key, std::string_view value) {
  if (key == "extruder") return value == "0" || value == "1";
  constexpr std::array kWords = {"volume_type", "modifier", "matrix", "mesh_stat", "text", "svg"};
  return key.empty() || key.starts_with("source_") ||
         std::find(kWords.begin(), kWords.end(), key) != kWords.end();
}

// One of the entries.
class RolesReader {
 public:
  RolesReader(XmlScanner& xml, ThreeMfRoles& roles) : xml_(xml), roles_(roles) {}

  [[nodiscard]] Status read() {
    while (true) {
      const Result<const XmlEvent*> event = xml_.next();
      if (!event.ok()) return event.error();
      if (event.value() == nullptr) return {};
      Status taken;
      if (event.value()->kind == XmlEvent::Kind::kStart) taken = start(*event.value());
      if (event.value()->kind == XmlEvent::Kind::kEnd) taken = end(event.value()->name);
      if (!taken.ok()) return taken;
    }
  }

 private:
  static std::string text_of(const XmlEvent& event, const char* name) {
    const std::string* text = event.attribute(name);
    return text == nullptr ? "" : *text;
  }

  [[nodiscard]] Status start(const XmlEvent& event) {
    if (event.name == "object") {
      object_ = text_of(event, "id");
      object_settings_.clear();
      object_name_ = object_;
    } else if (event.name == "plate") {
      ++roles_.plates;
    } else if (event.name == "part") {
      open_ = true;
      part_ = text_of(event, "id");
      kind_ = part_kind_of(text_of(event, "subtype"));
      settings_.clear();
      name_.clear();
      note_unknown(text_of(event, "subtype"));
    } else if (event.name == "volume") {
      return volume(event);
    } else if (event.name == "metadata" && !object_.empty()) {
      return metadata(text_of(event, "key"), text_of(event, "value"));
    }
    return {};
  }

  [[nodiscard]] Status volume(const XmlEvent& event) {
    const std::optional<std::int64_t> first = parse_integer(text_of(event, "firstid"));
    const std::optional<std::int64_t> last = parse_integer(text_of(event, "lastid"));
    if (!first || !last || *first < 0 || *last + 1 < *first) {
      return xml_.bad("a volume without a first and a last triangle; export the part again");
    }
    open_ = true;
    part_.clear();
    kind_ = PartKind::kPlastic;
    settings_.clear();
    name_.clear();
    range_ = {static_cast<std::size_t>(*first), static_cast<std::size_t>(*last + 1), {}};
    return {};
  }

  [[nodiscard]] Status metadata(const std::string& key, const std::string& value) {
    if (key == "name") {
      (open_ ? name_ : object_name_) = value;
      const bool room = !open_ && roles_.names.size() < kMeshObjectsMax;
      if (room) roles_.names[object_] = value;
    } else if (!is_no_setting(key, value)) {
      ModifierSettings& into = open_ ? settings_ : object_settings_;
      if (into.size() >= kBodySettingsMax) return xml_.bad("too many settings of one body");
      into.emplace_back(key, value);
    }
    if (open_) role_word(key, value);
    return {};
  }

  void role_word(const std::string& key, const std::string& value) {
    if (key == "volume_type") {
      kind_ = part_kind_of(value);
      note_unknown(value);
    } else if (key == "modifier" && value == "1" && kind_ == PartKind::kPlastic) {
      kind_ = PartKind::kModifier;
    }
  }

  void note_unknown(const std::string& word) {
    if (kind_ == PartKind::kUnknown && roles_.unknown.empty()) roles_.unknown = shown(word);
  }

  // Of a modifier with settings; kLeftOut for others.
  MeshRole note_modifier() {
    const std::size_t number = bodies_;
    if (settings_.empty() || number >= kModifiersMax) {
      ++roles_.modifiers;
      return MeshRole::kLeftOut;
    }
    ++bodies_;
    const std::string& name = name_.empty() ? part_ : name_;
    roles_.changes.push_back(
        {"modifier '" + shown(name) + "'", std::move(settings_), modifier_role(number), {}});
    return modifier_role(number);
  }

  void note_object() {
    if (object_settings_.empty()) return;
    const std::string name = "object '" + shown(object_name_) + "'";
    if (objects_ < kModifiersMax) {
      ++objects_;
      roles_.changes.push_back({name, std::move(object_settings_), MeshRole::kSolid, object_});
    } else {
      note_unused(name, object_settings_);
    }
    object_settings_.clear();
  }

  void note_unused(const std::string& name, const ModifierSettings& settings) {
    if (settings.empty() || roles_.unused.size() >= kModifiersMax) return;
    std::string keys;
    for (const auto& [key, value] : settings) keys += (keys.empty() ? "" : ", ") + shown(key);
    roles_.unused.push_back(name + ": " + keys);
  }

  [[nodiscard]] Status end(const std::string& name) {
    if (name == "object") {
      note_object();
      object_.clear();
    }
    if (!open_ || (name != "part" && name != "volume")) return {};
    open_ = false;
    if (kind_ == PartKind::kPlastic || kind_ == PartKind::kUnknown) {
      note_unused("part '" + shown(name_) + "'", settings_);
      return {};
    }
    if (kind_ == PartKind::kSupportEnforcer) ++roles_.enforcers;
    if (kind_ == PartKind::kSupportBlocker) ++roles_.blockers;
    if (++taken_ > kMeshObjectsMax) return xml_.bad("too many parts; merge them");
    const MeshRole role = kind_ == PartKind::kModifier ? note_modifier() : role_of(kind_);
    if (name == "part") {
      roles_.parts[{object_, part_}] = role;
    } else if (range_.last > range_.first) {
      roles_.volumes[object_].push_back({range_.first, range_.last - 1, role});
    }
    return {};
  }

  XmlScanner& xml_;
  ThreeMfRoles& roles_;
  std::string object_;
  bool open_ = false;  // within a part or a volume
  std::string part_;
  RoleRange range_;  // of a volume
  PartKind kind_ = PartKind::kPlastic;
  std::string name_, object_name_;
  ModifierSettings settings_, object_settings_;  // of the part or volume; of the object
  std::size_t bodies_ = 0, objects_ = 0;         // with settings
  std::size_t taken_ = 0;
};

}  // namespace

std::vector<std::string> ThreeMfRoles::left_out() const {
  std::vector<std::string> texts;
  if (modifiers > 0) {
    texts.push_back(counted(modifiers, "modifier") +
                    " left out: no plastic, and its settings are not used");
  }
  for (const std::string& one : unused) {
    texts.push_back(one +
                    ": not used: only modifiers and whole objects have settings of their "
                    "own");
  }
  if (plates > 1) {
    texts.push_back("the file has " + std::to_string(plates) +
                    " plates; what is on them is taken together");
  }
  if (!unknown.empty()) {
    texts.push_back("a part of type '" + unknown + "', which is not known, is taken as plastic");
  }
  return texts;
}

bool in_order(std::vector<RoleRange>& ranges) {
  std::sort(ranges.begin(), ranges.end(),
            [](const RoleRange& a, const RoleRange& b) { return a.first < b.first; });
  for (std::size_t i = 1; i < ranges.size(); ++i) {
    if (ranges[i].first <= ranges[i - 1].last) return false;
  }
  return true;
}

Result<ThreeMfRoles> read_roles(const ZipArchive& archive) {
  ThreeMfRoles roles;
  for (const std::string& entry : archive.entries()) {
    const std::string key = entry_key(entry);
    const bool has_roles =
        key.starts_with("metadata/") &&
        (key.ends_with("model_settings.config") || key.ends_with("_model.config"));
    if (!has_roles) continue;
    Result<XmlScanner::ByteSource> bytes = archive.bytes_of(entry);
    if (!bytes.ok()) return bytes.error();
    XmlScanner xml(archive.name() + " (" + entry + ")", std::move(bytes).value(), false);
    if (Status read = RolesReader(xml, roles).read(); !read.ok()) return read.error();
  }
  for (auto& [object, ranges] : roles.volumes) {
    if (in_order(ranges)) continue;
    return core::Error{core::ErrorCode::kBadPart,
                       archive.name() + ": object '" + shown(object) +
                           "' has volumes that share triangles; export the part again"};
  }
  return roles;
}

}  // namespace host
