#include "host/settings/cura_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "host/settings/gcode_expression.h"
#include "host/settings/settings_file.h"  // profile_text
#include "host/settings/settings_text.h"  // escaped, read_number, write_number

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;
using nlohmann::json;

struct CuraValue {
  std::string place;
  std::string text;
  bool expression = false;
};

using CuraValues = std::map<std::string, CuraValue, std::less<>>;

Error bad(const std::string& name, const std::string& cause) {
  return {ErrorCode::kBadSetting, fmt::format("{}: {}", name, cause)};
}

bool is_root(const std::string& definition) {
  return definition == "fdmprinter" || definition == "fdmextruder";
}

std::string literal(const json& value) {
  if (value.is_string()) return escaped(value.get<std::string>());
  if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
  return value.is_number() ? write_number(value.get<double>()) : std::string();
}

// The definition's overrides over those that it inherits.
Status collect(std::string_view text, const std::string& name, int depth, CuraValues& values) {
  const json all = json::parse(text, nullptr, false, true);
  if (!all.is_object()) return bad(name, "is not valid JSON; copy the definition again");
  const std::string parent = all.contains("inherits") && all["inherits"].is_string()
                                 ? all["inherits"].get<std::string>()
                                 : std::string();
  if (!parent.empty() && !is_root(parent)) {
    if (depth == kInheritsMax) {
      return bad(name,
                 fmt::format("inherits over more than {} files, or from itself", kInheritsMax));
    }
    namespace fs = std::filesystem;
    const std::string path = (fs::path(name).parent_path() / (parent + ".def.json")).string();
    std::error_code error;
    if (parent.find('/') != std::string::npos || !fs::is_regular_file(path, error)) {
      return bad(name, fmt::format("inherits \"{0}\", but {0}.def.json is not beside it; copy that "
                                   "file there",
                                   parent));
    }
    const Result<std::string> above = profile_text(path);
    if (!above.ok()) return above.error();
    if (Status done = collect(above.value(), path, depth + 1, values); !done.ok()) return done;
  }
  if (!all.contains("overrides") || !all["overrides"].is_object()) return {};
  for (const auto& [key, one] : all["overrides"].items()) {
    if (!one.is_object()) continue;
    const bool has_value = one.contains("value");
    if (!has_value && !one.contains("default_value")) continue;
    const json& said = has_value ? one["value"] : one["default_value"];
    const bool expression = has_value && said.is_string();
    values.insert_or_assign(
        key, CuraValue{fmt::format("{}: {}", name, key),
                       expression ? said.get<std::string>() : literal(said), expression});
  }
  return {};
}

// Works out expressions, as far as they are understood.
class Solver {
 public:
  explicit Solver(const CuraValues& values) : values_(values) {}

  [[nodiscard]] std::optional<std::string> solve(std::string_view key, int depth = 0) const {
    const auto found = values_.find(key);
    if (found == values_.end()) return std::nullopt;
    if (!found->second.expression) return found->second.text;
    if (depth == kExpressionDepthMax) return std::nullopt;
    std::string text = found->second.text;
    std::replace(text.begin(), text.end(), '\'', '"');
    const VariableLookup lookup = [&](std::string_view name,
                                      std::size_t) -> Result<std::optional<Variable>> {
      if (name == "True" || name == "False") {
        return std::optional(Variable{name == "True" ? "1" : "0", VariableKind::kWhole});
      }
      const std::optional<std::string> known = solve(name, depth + 1);
      if (!known) return std::optional<Variable>();
      const bool number = read_number(*known, "").ok();
      return std::optional(Variable{*known, number ? VariableKind::kNumber : VariableKind::kText});
    };
    Cursor cursor{text};
    const Result<ExpressionValue> value = read_expression(cursor, lookup, true);
    cursor.skip_space();
    if (!value.ok() || !cursor.done()) return std::nullopt;
    if (const auto* is = std::get_if<bool>(&value.value())) return *is ? "1" : "0";
    return text_of(value.value());
  }

 private:
  const CuraValues& values_;
};

// As PrusaSlicer's bed_shape. Cura's round beds are ellipses.
std::optional<std::string> bed_of(const Solver& solver) {
  const auto number = [&solver](const char* key) -> std::optional<double> {
    const std::optional<std::string> text = solver.solve(key);
    const Result<double> read = read_number(text.value_or(""), "");
    return read.ok() ? std::optional(read.value()) : std::nullopt;
  };
  const std::optional<double> width = number("machine_width"), depth = number("machine_depth");
  if (!width || !depth) return std::nullopt;
  const bool centred = number("machine_center_is_zero").value_or(0) != 0;
  const double x = centred ? -*width / 2 : 0, y = centred ? -*depth / 2 : 0;
  std::string text;
  const auto add = [&text](double cx, double cy) {
    text +=
        fmt::format("{}{}x{}", text.empty() ? "" : ",", write_number(std::round(cx * 1e4) / 1e4),
                    write_number(std::round(cy * 1e4) / 1e4));
  };
  const std::string shape = solver.solve("machine_shape").value_or("rectangular");
  if (shape != "elliptic") {
    for (const auto& [cx, cy] :
         {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
      add(x + cx * *width, y + cy * *depth);
    }
    return text;
  }
  constexpr int kCorners = 72;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    add(x + *width / 2 * (1 + std::cos(angle)), y + *depth / 2 * (1 + std::sin(angle)));
  }
  return text;
}

ForeignProfile profile_of(const CuraValues& values, const std::string& name) {
  ForeignProfile profile{"Cura", GcodeOrigin::kCura, {}, {}, {}};
  const Solver solver(values);
  const auto is = [&solver](const char* key, const char* word) {
    const std::optional<std::string> said = solver.solve(key);
    return said && *said == word;
  };
  for (const auto& [key, value] : values) {
    const std::optional<std::string> solved = solver.solve(key);
    // What is not understood keeps its text, which no setting takes.
    if (!solved) {
      profile.unsolved.push_back({value.place, "", key, value.text});
      continue;
    }
    profile.lines.push_back({value.place, "", key, *solved});
  }
  const bool sized = values.contains("machine_width") || values.contains("machine_depth");
  if (sized) {
    profile.lines.push_back(
        {name + ": machine_width, machine_depth", "", "bed_shape", bed_of(solver).value_or("")});
  }
  // One of these is laid around the part.
  if (values.contains("adhesion_type")) {
    const std::string place = name + ": adhesion_type";
    if (!is("adhesion_type", "brim")) profile.lines.push_back({place, "", "brim_width", "0"});
    if (!is("adhesion_type", "skirt")) profile.lines.push_back({place, "", "skirts", "0"});
  }
  if (is("support_structure", "tree")) {
    profile.lines.push_back({name + ": support_structure", "", "support_material_style", "tree"});
  }
  return profile;
}

}  // namespace

bool is_cura_definition(std::string_view text) {
  const json all = json::parse(text, nullptr, false, true);
  return all.is_object() &&
         (all.contains("overrides") || (all.contains("settings") && all.contains("metadata")));
}

bool is_cura_instance(const std::vector<ProfileLine>& lines) {
  const auto has = [&lines](std::string_view section) {
    return std::any_of(lines.begin(), lines.end(),
                       [section](const ProfileLine& line) { return line.section == section; });
  };
  return has("general") && (has("values") || has("metadata"));
}

Result<ForeignProfile> read_cura_definition(std::string_view text, const std::string& name) {
  CuraValues values;
  if (Status done = collect(text, name, 0, values); !done.ok()) return done.error();
  return profile_of(values, name);
}

Result<ForeignProfile> read_cura_instance(const std::vector<ProfileLine>& lines,
                                          const std::string& name) {
  CuraValues values;
  for (const ProfileLine& line : lines) {
    if (line.section != "values") continue;
    const bool expression = line.value.starts_with('=');
    values.insert_or_assign(
        line.key,
        CuraValue{line.place, expression ? line.value.substr(1) : line.value, expression});
  }
  return profile_of(values, name);
}

}  // namespace host
