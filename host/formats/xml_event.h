// What XML consists of, piece by piece.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace host {

struct XmlEvent {
  enum class Kind { kStart, kEnd, kText };
  Kind kind = Kind::kStart;
  std::string space;  // the name's namespace; may be empty
  std::string name;   // without prefix; for kText, the text, perhaps in pieces
  // Names with a prefix are given as "namespace|name".
  std::vector<std::pair<std::string, std::string>> attributes;
  std::int64_t line = 0;

  // Null if there is no such attribute. Valid as long as the event.
  [[nodiscard]] const std::string* attribute(std::string_view wanted) const {
    for (const auto& [key, value] : attributes) {
      if (key == wanted) return &value;
    }
    return nullptr;
  }
};

}  // namespace host
