#include "host/settings/profile_bundle.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "host/settings/gcode_expression.h"    // read_expression
#include "host/settings/placeholder_values.h"  // profile_value
#include "host/system/text.h"                  // lower_case, trimmed

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

// A profile's lines by their keys; a later parent, and the profile itself, win.
using Merged = std::map<std::string, ProfileLine, std::less<>>;

// "a; b", each perhaps in quotes.
std::vector<std::string> names_in(std::string_view list) {
  std::vector<std::string> names;
  while (!list.empty()) {
    std::string_view one = list.substr(0, list.find(';'));
    list.remove_prefix(std::min(list.size(), one.size() + 1));
    one = trimmed(one);
    if (one.size() >= 2 && one.front() == '"' && one.back() == '"') {
      one = one.substr(1, one.size() - 2);
    }
    if (!one.empty()) names.emplace_back(one);
  }
  return names;
}

std::string_view value_in(const Merged& merged, std::string_view key) {
  const auto found = merged.find(key);
  return found == merged.end() ? std::string_view() : std::string_view(found->second.value);
}

std::string first_in(const Merged& merged, std::string_view key) {
  const std::vector<std::string> names = names_in(value_in(merged, key));
  return names.empty() ? std::string() : names.front();
}

class Bundle {
 public:
  Bundle(const std::vector<ProfileLine>& lines, std::string name) : name_(std::move(name)) {
    for (const ProfileLine& line : lines) {
      auto [section, is_new] = sections_.try_emplace(line.section);
      if (is_new) order_.push_back(line.section);
      section->second.push_back(&line);
    }
  }

  Result<ForeignProfile> choose(const ProfileChoice& choice) {
    const Result<std::string> printer = printer_named(choice.printer);
    if (!printer.ok()) return printer.error();
    const Result<Merged> machine = merged("printer", printer.value());
    if (!machine.ok()) return machine.error();
    if (value_in(machine.value(), "printer_technology") == "SLA") {
      return bad(fmt::format("{} hardens resin; rind lays filament", printer.value()));
    }
    ForeignProfile profile{"PrusaSlicer", GcodeOrigin::kProfile, {}, {}, {}};
    ids_ = {{"printer_settings_id", printer.value()}};
    const struct {
      const char* kind;
      const std::string& asked;
      const char* by_default;
    } kParts[] = {{"print", choice.quality, "default_print_profile"},
                  {"filament", choice.filament, "default_filament_profile"}};
    for (const auto& part : kParts) {
      const Result<std::string> which =
          fitting(part.kind, part.asked, part.by_default, machine.value());
      if (!which.ok()) return which.error();
      if (which.value().empty()) {
        profile.notes.push_back(
            fmt::format("{}: no {} profile is made for {}: rind's own settings "
                        "are used",
                        name_, part.kind, printer.value()));
        continue;
      }
      const Result<Merged> lines = merged(part.kind, which.value());
      if (!lines.ok()) return lines.error();
      for (const auto& [key, line] : lines.value()) profile.lines.push_back(line);
      ids_.emplace_back(fmt::format("{}_settings_id", part.kind), which.value());
    }
    for (const auto& [key, line] : machine.value()) profile.lines.push_back(line);
    add_known(machine.value(), profile);
    std::string chosen;
    for (const auto& [key, id] : ids_) {
      chosen +=
          fmt::format("{}{} \"{}\"", chosen.empty() ? "" : ", ", key.substr(0, key.find('_')), id);
    }
    profile.notes.insert(profile.notes.begin(), fmt::format("{}: {}", name_, chosen));
    return profile;
  }

 private:
  Error bad(const std::string& cause) const {
    return {ErrorCode::kBadSetting, fmt::format("{}: {}", name_, cause)};
  }

  // Names of that kind that are not there only to be inherited from.
  [[nodiscard]] std::vector<std::string> names_of(const std::string& kind) const {
    std::vector<std::string> names;
    for (const std::string& section : order_) {
      if (section.starts_with(kind + ":") && section[kind.size() + 1] != '*') {
        names.push_back(section.substr(kind.size() + 1));
      }
    }
    return names;
  }

  [[nodiscard]] static std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t kShown = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kShown); ++i) {
      text += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", names[i]);
    }
    return names.size() > kShown ? fmt::format("{} and {} more", text, names.size() - kShown)
                                 : text;
  }

  // Those that hold the asked text first, in any case.
  [[nodiscard]] static std::vector<std::string> likely(const std::vector<std::string>& names,
                                                       const std::string& asked) {
    std::vector<std::string> some;
    std::copy_if(names.begin(), names.end(), std::back_inserter(some), [&](const auto& name) {
      return lower_case(name).find(lower_case(asked)) != std::string::npos;
    });
    return some.empty() ? names : some;
  }

  Result<Merged> merged(const std::string& kind, const std::string& profile, int depth = 0) const {
    const auto section = sections_.find(kind + ":" + profile);
    if (section == sections_.end()) {
      return bad(fmt::format("there is no section [{}:{}], which another one inherits from", kind,
                             profile));
    }
    if (depth == kInheritsMax) {
      return bad(fmt::format("[{}:{}] inherits over more than {} profiles, or from itself", kind,
                             profile, kInheritsMax));
    }
    Merged whole;
    for (const ProfileLine* line : section->second) {
      if (line->key != "inherits") continue;
      for (const std::string& parent : names_in(line->value)) {
        Result<Merged> above = merged(kind, parent, depth + 1);
        if (!above.ok()) return above;
        for (auto& [key, inherited] : above.value()) whole.insert_or_assign(key, inherited);
      }
    }
    for (const ProfileLine* line : section->second) {
      if (line->key != "inherits") whole.insert_or_assign(line->key, *line);
    }
    return whole;
  }

  Result<std::string> printer_named(const std::string& asked) const {
    const std::vector<std::string> printers = names_of("printer");
    if (printers.empty()) return bad("is a bundle without a printer");
    if (asked.empty()) {
      return bad(fmt::format("is a bundle of {} printers; choose one by --printer: {}",
                             printers.size(), listed(printers)));
    }
    if (std::find(printers.begin(), printers.end(), asked) != printers.end()) return asked;
    for (const std::string& model : names_of("printer_model")) {
      const Result<Merged> of_model = merged("printer_model", model);
      if (!of_model.ok()) return of_model.error();
      std::string title(value_in(of_model.value(), "name"));
      // "&&" is a single one, as in menus.
      if (const std::size_t twice = title.find("&&"); twice != std::string::npos)
        title.erase(twice, 1);
      if (asked != model && asked != title) continue;
      const std::string variant = first_in(of_model.value(), "variants");
      for (const std::string& printer : printers) {
        const Result<Merged> lines = merged("printer", printer);
        if (!lines.ok()) return lines.error();
        if (value_in(lines.value(), "printer_model") != model) continue;
        if (variant.empty() || value_in(lines.value(), "printer_variant") == variant)
          return printer;
      }
    }
    return bad(fmt::format("there is no printer \"{}\"; there are {}", asked,
                           listed(likely(printers, asked))));
  }

  // Whether a print or filament says that it is made for the printer.
  [[nodiscard]] static bool made_for(const Merged& part, const Merged& machine) {
    const std::string condition(value_in(part, "compatible_printers_condition"));
    if (trimmed(condition).empty()) return true;
    ProfileValues values;
    for (const auto& [key, line] : machine) values.insert_or_assign(key, line.value);
    const VariableLookup lookup = [&values](std::string_view name, std::size_t index) {
      return Result<std::optional<Variable>>(profile_value(values, name, index));
    };
    Cursor cursor{condition};
    const Result<ExpressionValue> value = read_expression(cursor, lookup, true);
    return value.ok() && holds(value.value());
  }

  // The print or filament that is asked for, or the default one; empty: there is none.
  Result<std::string> fitting(const std::string& kind, const std::string& asked,
                              const char* by_default, const Merged& machine) const {
    const std::vector<std::string> all = names_of(kind);
    const auto is_there = [&all](const std::string& one) {
      return std::find(all.begin(), all.end(), one) != all.end();
    };
    if (!asked.empty() && is_there(asked)) return asked;
    const std::string own = first_in(machine, by_default);
    if (asked.empty() && is_there(own)) return own;
    std::vector<std::string> made;
    for (const std::string& one : all) {
      const Result<Merged> part = merged(kind, one);
      if (!part.ok()) return part.error();
      if (made_for(part.value(), machine)) made.push_back(one);
      if (asked.empty() && !made.empty()) return made.front();
    }
    if (asked.empty()) return std::string();
    const char* option = kind == "print" ? "--quality" : "--filament";
    return bad(fmt::format("{} \"{}\": there is no such {} profile; for this printer there are {}",
                           option, asked, kind, listed(likely(made.empty() ? all : made, asked))));
  }

  // The names of what was chosen, and the bed that PrusaSlicer has where a printer says none.
  void add_known(const Merged& machine, ForeignProfile& profile) const {
    for (const auto& [key, id] : ids_) profile.lines.push_back({name_, "", key, id});
    if (machine.find("bed_shape") == machine.end()) {
      profile.lines.push_back({name_, "", "bed_shape", "0x0,200x0,200x200,0x200"});
    }
  }

  std::string name_;
  std::map<std::string, std::vector<const ProfileLine*>> sections_;
  std::vector<std::string> order_;
  std::vector<std::pair<std::string, std::string>> ids_;
};

}  // namespace

bool is_bundle(const std::vector<ProfileLine>& lines) {
  return std::any_of(lines.begin(), lines.end(), [](const ProfileLine& line) {
    return line.section.starts_with("printer:") || line.section.starts_with("print:") ||
           line.section.starts_with("filament:") || line.section.starts_with("printer_model:");
  });
}

Result<ForeignProfile> chosen_from_bundle(const std::vector<ProfileLine>& lines,
                                          const std::string& name, const ProfileChoice& choice) {
  return Bundle(lines, name).choose(choice);
}

}  // namespace host
