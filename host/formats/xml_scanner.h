// Parses XML as a stream of events; the document is not kept.
//
// Errors, with the line: an entity that the document declares (entities can expand without end);
// elements nested deeper than kNestingMax; a tag or text longer than kXmlTokenBytesMax.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"             // Result
#include "host/formats/xml_event.h"  // XmlEvent

namespace host {

class XmlScanner {
 public:
  // Reads the next bytes into a buffer of that size; 0 at the end.
  using ByteSource = std::function<core::Result<std::size_t>(char*, std::size_t)>;

  // `name` is the file, for messages. Without `wants_text`, there are no kText events.
  XmlScanner(std::string name, ByteSource bytes, bool wants_text);
  ~XmlScanner();
  XmlScanner(XmlScanner&&) noexcept;

  // Elements of these names, without prefix, hold many plain ones (plain_element.h). Those are read
  // several times as fast, and have no kEnd. REQUIRES: before the first next(); without text
  void expect_lists(std::vector<std::string> names);

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
