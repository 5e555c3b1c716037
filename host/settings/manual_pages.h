// Manual pages, for man: rind(1), one for each command, and rind.ini(5) with all settings.
#pragma once

#include <string>
#include <vector>

#include "host/settings/command_texts.h"
#include "host/settings/settings_table.h"  // SettingRow

namespace host {

struct ManualPage {
  std::string name;  // of its file: "rind-print.1"
  std::string text;  // in man's macros, UTF-8
};

// rind.1 first, then a page for each command in their order, then rind.ini.5.
[[nodiscard]] std::vector<ManualPage> manual_pages(const ProgramText& program,
                                                   const std::vector<SettingRow>& settings);

// Text that means itself in a page: its minus signs, quotes and backslashes are not read as others.
[[nodiscard]] std::string manual_text(const std::string& text);

}  // namespace host
