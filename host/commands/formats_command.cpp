#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/commands/commands.h"
#include "host/formats/formats.h"

namespace host {

int formats_command(const Options& options, Reporter& reporter) {
  if (options.json) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const FormatRow& row : formats()) {
      json.push_back({{"name", row.name},
                      {"extensions", row.extensions},
                      {"holds", row.holds},
                      {"reads", row.reads},
                      {"writes", row.writes},
                      {"remarks", row.remarks}});
    }
    return show_result(json.dump(2) + "\n", reporter);
  }
  std::string text = fmt::format("{:<12} {:<12} {:<7} {:<5} {:<6} {}\n", "format", "named", "holds",
                                 "read", "write", "");
  for (const FormatRow& row : formats()) {
    text += fmt::format("{:<12} {:<12} {:<7} {:<5} {:<6} {}\n", row.name, row.extensions, row.holds,
                        row.reads ? "yes" : "-", row.writes ? "yes" : "-", row.remarks);
  }
  return show_result(text, reporter);
}

}  // namespace host
