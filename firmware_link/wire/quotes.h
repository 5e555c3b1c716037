// A controller's own words in a message.
#pragma once

#include <string>
#include <string_view>

namespace firmware_link {

// Not called quoted(): a call with a string would find std::quoted(), too.
[[nodiscard]] inline std::string in_quotes(std::string_view words) {
  return "\"" + std::string(words) + "\"";
}

}  // namespace firmware_link
