#include "host/settings/prusa_texts.h"

#include <cstddef>

#include "host/settings/settings_text.h"  // is_printable, kWordsBytesMax
#include "host/system/text.h"             // trimmed

namespace host {

std::string prusa_name_text(std::string_view text) {
  std::string name(trimmed(text));
  if (name.starts_with('"')) {
    const std::string quoted = std::move(name);
    name.clear();
    for (std::size_t i = 1; i < quoted.size() && quoted[i] != '"'; ++i) {
      if (quoted[i] == '\\' && i + 1 < quoted.size()) ++i;
      name += quoted[i];
    }
  }
  name = trimmed(name);
  return is_printable(name) && name.size() <= kWordsBytesMax ? name : std::string();
}

std::string first_prusa_name(std::string_view text) {
  const std::string_view list = trimmed(text);
  return prusa_name_text(list.starts_with('"') ? list : list.substr(0, list.find(';')));
}

}  // namespace host
