// Bytes as text (RFC 4648, section 4): four characters for three bytes, with '=' at the end.
#pragma once

#include <string>
#include <string_view>

namespace host {

[[nodiscard]] std::string base64_of(std::string_view bytes);

}  // namespace host
