// Parses XML as a stream of events; the document is not kept.
//
// Errors, with the line: an entity that the document declares (entities can expand without end);
// elements nested deeper than kNestingMax; a tag or text longer than kXmlTokenBytesMax.
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
  std::string space;  // the name's namespace; may be empty
  std::string name;   // without prefix; for kText, the text, perhaps in pieces
  // Names with a prefix are given as "namespace|name".
  std::vector<std::pair<std::string, std::string>> attributes;
  std::int64_t line = 0;

  // Null if there is no such attribute. Valid as long as the event.
  [[nodiscard]] const std::string* attribute(std::string_view wanted) const;
};

class XmlScanner {
 public:
  // Reads the next bytes into a buffer of that size; 0 at the end.
  using ByteSource = std::function<core::Result<std::size_t>(char*, std::size_t)>;

  // `name` is the file, for messages. Without `wants_text`, there are no kText events.
  XmlScanner(std::string name, ByteSource bytes, bool wants_text);
  ~XmlScanner();
  XmlScanner(XmlScanner&&) noexcept;

  // The next event, valid until the next call; null at the document's end. An error is final.
  [[nodiscard]] core::Result<const XmlEvent*> next();

  // The namespace that a prefix was declared for so far; empty if none. The first kNestingMax
  // declarations are kept.
  [[nodiscard]] std::string namespace_of(const std::string& prefix) const;

  // An error with file, line of the last event, and cause.
  [[nodiscard]] core::Error bad(const std::string& cause) const;
  [[nodiscard]] const std::string& name() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace host
