#include "host/settings/profile_json.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "host/settings/cura_profile.h"
#include "host/settings/settings_file.h"  // profile_text
#include "host/settings/settings_text.h"  // escaped, write_number

namespace host {
namespace {

namespace fs = std::filesystem;

using core::Error;
using core::ErrorCode;
using core::Result;
using nlohmann::json;

using Merged = std::map<std::string, ProfileLine, std::less<>>;

Error bad(const std::string& name, const std::string& cause) {
  return {ErrorCode::kBadSetting, fmt::format("{}: {}", name, cause)};
}

std::string scalar_text(const json& value) {
  if (value.is_string()) return escaped(value.get<std::string>());
  if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
  if (value.is_number()) return write_number(value.get<double>());
  return {};
}

// Texts of lists stand between semicolons, numbers and points between commas.
std::string list_text(std::string_view key, const json& list) {
  // A filament's G-code is a list of one.
  if (key.ends_with("_gcode")) return list.empty() ? std::string() : scalar_text(list.front());
  const bool texts = key.starts_with("filament_") || key.starts_with("default_");
  std::string text;
  for (const json& one : list) {
    if (&one != &list.front()) text += texts ? ";" : ",";
    text += scalar_text(one);
  }
  return text;
}

std::string text_at(const Merged& merged, std::string_view key) {
  const auto found = merged.find(key);
  return found == merged.end() ? std::string() : found->second.value;
}

// The file of that name in the folder, in those beside it, and in folders of these.
std::optional<std::string> find_file(const fs::path& beside, const std::string& name) {
  if (name.empty() || name.find('/') != std::string::npos || name.find('\\') != std::string::npos) {
    return std::nullopt;
  }
  std::error_code error;
  fs::path folder = fs::absolute(beside, error).parent_path();
  const std::string file = name + ".json";
  int left = kProfileFoldersMax;
  if (fs::is_regular_file(folder / file, error)) return (folder / file).string();
  for (const fs::path& root : {folder.parent_path(), folder.parent_path().parent_path()}) {
    fs::recursive_directory_iterator at(root, fs::directory_options::skip_permission_denied, error);
    for (; !error && at != fs::recursive_directory_iterator() && left > 0; at.increment(error)) {
      if (!at->is_directory(error)) continue;
      --left;
      if (at.depth() >= 2) at.disable_recursion_pending();
      if (fs::is_regular_file(at->path() / file, error)) return (at->path() / file).string();
    }
  }
  return std::nullopt;
}

Result<json> parsed(std::string_view text, const std::string& name) {
  json all = json::parse(text, nullptr, false, true);
  if (all.is_discarded()) return bad(name, "is not valid JSON; export the profile again");
  if (!all.is_object()) return bad(name, "is JSON, but no profile");
  return all;
}

// The file's own settings over those that it inherits.
Result<Merged> merged(const json& all, const std::string& name, int depth = 0) {
  Merged whole;
  const auto inherits = all.find("inherits");
  if (inherits != all.end() && inherits->is_string() && !inherits->get<std::string>().empty()) {
    const std::string parent = inherits->get<std::string>();
    if (depth == kInheritsMax) {
      return bad(name,
                 fmt::format("inherits over more than {} files, or from itself", kInheritsMax));
    }
    const std::optional<std::string> path = find_file(name, parent);
    if (!path) {
      return bad(name, fmt::format("inherits \"{0}\", but {0}.json is neither beside it nor in a "
                                   "folder near it; copy that file there",
                                   parent));
    }
    const Result<std::string> text = profile_text(*path);
    if (!text.ok()) return text.error();
    const Result<json> above = parsed(text.value(), *path);
    if (!above.ok()) return above.error();
    Result<Merged> inherited = merged(above.value(), *path, depth + 1);
    if (!inherited.ok()) return inherited;
    whole = std::move(inherited).value();
  }
  for (const auto& [key, value] : all.items()) {
    if (key == "inherits") continue;
    const std::string text = value.is_array() ? list_text(key, value) : scalar_text(value);
    whole.insert_or_assign(key, ProfileLine{fmt::format("{}: {}", name, key), "", key, text});
  }
  return whole;
}

// What a profile is called is the name that its program writes into files.
void append_name(const Merged& from, ForeignProfile& profile) {
  const std::string type = text_at(from, "type"), name = text_at(from, "name");
  if (name.empty() || (type != "machine" && type != "filament")) return;
  const std::string key = type == "machine" ? "printer_settings_id" : "filament_settings_id";
  profile.lines.push_back({from.find("name")->second.place, "", key, name});
}

void append(const Merged& from, ForeignProfile& profile) {
  for (const auto& [key, line] : from) {
    // Words there, switches in PrusaSlicer.
    if (key == "ironing_type") {
      const bool off = line.value == "no ironing";
      profile.lines.push_back({line.place, "", "ironing", off ? "0" : "1"});
      continue;
    }
    profile.lines.push_back(line);
    if (key == "support_type") {
      const bool manual = line.value.find("manual") != std::string::npos;
      profile.lines.push_back({line.place, "", "support_material_auto", manual ? "0" : "1"});
    }
  }
  append_name(from, profile);
}

// Adds the print or the filament that goes with a printer.
core::Status add_part(const std::string& machine, const char* kind, const char* option,
                      const std::string& asked, const std::string& by_default,
                      ForeignProfile& profile) {
  const std::string& wanted = asked.empty() ? by_default : asked;
  if (wanted.empty()) return {};
  std::error_code error;
  std::optional<std::string> path = find_file(machine, wanted);
  if (!path && !asked.empty() && fs::is_regular_file(asked, error)) path = asked;
  if (!path && !asked.empty()) {
    return bad(machine,
               fmt::format("{} \"{}\": there is no such file near the printer's", option, asked));
  }
  if (!path) {
    profile.notes.push_back(
        fmt::format("{}: its default {} \"{}\" is not near it: rind's own "
                    "settings are used; name one by {}",
                    machine, kind, wanted, option));
    return {};
  }
  const Result<std::string> text = profile_text(*path);
  if (!text.ok()) return text.error();
  const Result<json> all = parsed(text.value(), *path);
  if (!all.ok()) return all.error();
  const Result<Merged> part = merged(all.value(), *path);
  if (!part.ok()) return part.error();
  append(part.value(), profile);
  profile.notes.push_back(fmt::format("{}: {} {}", machine, kind, *path));
  return {};
}

// The first name of "a;b".
std::string first_name(const std::string& list) { return list.substr(0, list.find(';')); }

}  // namespace

Result<ForeignProfile> read_json_profile(std::string_view text, const std::string& name,
                                         const ProfileChoice& choice) {
  const Result<json> all = parsed(text, name);
  if (!all.ok()) return all.error();
  if (is_cura_definition(text)) return read_cura_definition(text, name);
  const bool known = all.value().contains("type") || all.value().contains("printable_area") ||
                     all.value().contains("layer_height") || all.value().contains("inherits");
  if (!known) {
    return bad(name, "is JSON, but no profile of OrcaSlicer, Bambu Studio or Cura that rind knows");
  }
  if (!choice.printer.empty()) {
    return bad(name, "is one printer's profile: there is nothing to choose by --printer");
  }
  const Result<Merged> own = merged(all.value(), name);
  if (!own.ok()) return own.error();
  ForeignProfile profile{"OrcaSlicer", GcodeOrigin::kProfile, {}, {}, {}};
  if (text_at(own.value(), "type") == "machine") {
    core::Status added =
        add_part(name, "print", "--quality", choice.quality,
                 first_name(text_at(own.value(), "default_print_profile")), profile);
    if (added.ok()) {
      added = add_part(name, "filament", "--filament", choice.filament,
                       first_name(text_at(own.value(), "default_filament_profile")), profile);
    }
    if (!added.ok()) return added.error();
  }
  append(own.value(), profile);
  return profile;
}

}  // namespace host
