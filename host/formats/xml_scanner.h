// XML as a row of events, from bytes that come in pieces: nothing of the document is kept.
//
// Refused, with the line: entities that the document declares (they can be made to expand without
// end), more than kNestingMax elements within one another, and one tag or text longer than
// kXmlTokenBytesMax.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"  // Result

namespace host {

struct XmlEvent {
  enum class Kind { kStart, kEnd, kText };
  Kind kind = Kind::kStart;
  std::string space;  // the name's namespace; empty for none
  std::string name;   // without prefix; of a text: the text, perhaps in pieces
  // Names that have a prefix come as "namespace|name".
  std::vector<std::pair<std::string, std::string>> attributes;
  std::int64_t line = 0;

  // Nothing where there is no such attribute. Valid as long as the event.
  [[nodiscard]] const std::string* attribute(std::string_view wanted) const;
};

class XmlScanner {
 public:
  // Puts the next bytes into a buffer of that size, none at the end.
  using ByteSource = std::function<core::Result<std::size_t>(char*, std::size_t)>;

  // `name` is the file, for messages. `wants_text`: without it, texts are left out.
  XmlScanner(std::string name, ByteSource bytes, bool wants_text);
  ~XmlScanner();
  XmlScanner(XmlScanner&&) noexcept;

  // The next event, valid until the next call; nothing at the document's end. An error is final.
  [[nodiscard]] core::Result<const XmlEvent*> next();

  // What a prefix has been declared to mean so far; empty for none. Of the first kNestingMax.
  [[nodiscard]] std::string namespace_of(const std::string& prefix) const;

  // File, line of the last event, cause.
  [[nodiscard]] core::Error bad(const std::string& cause) const;
  [[nodiscard]] const std::string& name() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace host
