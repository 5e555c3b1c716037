#include "host/formats/xml_scanner.h"

#include <expat.h>

#include <array>
#include <map>

#include "host/formats/format_limits.h"  // kNestingMax, kXmlTokenBytesMax

namespace host {
namespace {

// Where the parser is. Expat 2.9 counts in 64 bits everywhere, by functions of their own.
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
std::int64_t line_of(XML_Parser parser) {
  return static_cast<std::int64_t>(XML_GetCurrentLineNumber64(parser));
}
std::int64_t byte_of(XML_Parser parser) { return XML_GetCurrentByteIndex64(parser); }
#else
std::int64_t line_of(XML_Parser parser) {
  return static_cast<std::int64_t>(XML_GetCurrentLineNumber(parser));
}
std::int64_t byte_of(XML_Parser parser) { return XML_GetCurrentByteIndex(parser); }
#endif

using core::Error;
using core::ErrorCode;
using core::Result;

constexpr std::size_t kPieceBytes = std::size_t{1} << 15;
constexpr char kSeparator = '|';

}  // namespace

const std::string* XmlEvent::attribute(std::string_view wanted) const {
  for (const auto& [key, value] : attributes) {
    if (key == wanted) return &value;
  }
  return nullptr;
}

// Events of one piece, collected by expat's callbacks; their memory is reused.
struct XmlScanner::State {
  std::string name;
  ByteSource bytes;
  XML_Parser parser = nullptr;
  std::array<char, kPieceBytes> piece{};
  std::vector<XmlEvent> events;
  std::size_t gathered = 0;
  std::size_t next = 0;
  std::int64_t fed_bytes = 0;
  int depth = 0;
  bool ended = false;
  std::int64_t line = 1;
  std::map<std::string, std::string> prefixes;
  std::string refusal;  // why a callback stopped the parser

  ~State() {
    if (parser != nullptr) XML_ParserFree(parser);
  }

  XmlEvent& add(XmlEvent::Kind kind) {
    if (gathered == events.size()) events.emplace_back();
    XmlEvent& event = events[gathered++];
    event.kind = kind;
    event.space.clear();
    event.name.clear();
    event.line = line_of(parser);
    return event;
  }

  void refuse(const std::string& why) {
    if (refusal.empty()) refusal = why;
    XML_StopParser(parser, XML_FALSE);
  }

  static State& of(void* data) { return *static_cast<State*>(data); }

  static void set_name(const char* full, XmlEvent& event) {
    const std::string_view text(full);
    const std::size_t at = text.rfind(kSeparator);
    if (at == std::string_view::npos) {
      event.name = text;
    } else {
      event.space = text.substr(0, at);
      event.name = text.substr(at + 1);
    }
  }

  static void on_start(void* data, const char* name, const char** attributes) {
    State& state = of(data);
    if (++state.depth > kNestingMax) {
      return state.refuse("more than " + std::to_string(kNestingMax) +
                          " elements within one another; export the file again");
    }
    XmlEvent& event = state.add(XmlEvent::Kind::kStart);
    set_name(name, event);
    std::size_t count = 0;
    for (; attributes[2 * count] != nullptr; ++count) {
      if (count == event.attributes.size()) event.attributes.emplace_back();
      event.attributes[count].first = attributes[2 * count];
      event.attributes[count].second = attributes[2 * count + 1];
    }
    event.attributes.resize(count);
  }

  static void on_end(void* data, const char* name) {
    State& state = of(data);
    --state.depth;
    set_name(name, state.add(XmlEvent::Kind::kEnd));
  }

  static void on_text(void* data, const char* text, int size) {
    of(data).add(XmlEvent::Kind::kText).name.assign(text, static_cast<std::size_t>(size));
  }

  static void on_namespace(void* data, const char* prefix, const char* uri) {
    State& state = of(data);
    if (prefix == nullptr || uri == nullptr) return;
    if (state.prefixes.size() < static_cast<std::size_t>(kNestingMax)) state.prefixes[prefix] = uri;
  }

  static void on_entity(void* data, const char*, int, const char*, int, const char*, const char*,
                        const char*, const char*) {
    of(data).refuse("the document declares entities, which is refused; export the file again");
  }

  [[nodiscard]] Error bad(const std::string& cause) const {
    return {ErrorCode::kBadPart, name + ": line " + std::to_string(line) + ": " + cause};
  }

  // Feeds one more piece.
  [[nodiscard]] core::Status feed() {
    const Result<std::size_t> count = bytes(piece.data(), piece.size());
    if (!count.ok()) return count.error();
    ended = count.value() == 0;
    fed_bytes += static_cast<std::int64_t>(count.value());
    const XML_Status status =
        XML_Parse(parser, piece.data(), static_cast<int>(count.value()), ended ? 1 : 0);
    if (status == XML_STATUS_OK) {
      const std::int64_t waiting = fed_bytes - byte_of(parser);
      if (waiting <= kXmlTokenBytesMax || ended) return {};
      refusal = "a tag or text of more than " + std::to_string(kXmlTokenBytesMax) +
                " bytes, more than fits; export the file again";
    }
    line = line_of(parser);
    if (!refusal.empty()) return bad(refusal);
    const XML_Error code = XML_GetErrorCode(parser);
    if (ended) {
      return bad(std::string("the document ends early (") + XML_ErrorString(code) +
                 "): it is cut short; copy or export it again");
    }
    return bad(std::string("no XML: ") + XML_ErrorString(code) + "; export the file again");
  }
};

XmlScanner::XmlScanner(std::string name, ByteSource bytes, bool wants_text)
    : state_(std::make_unique<State>()) {
  state_->name = std::move(name);
  state_->bytes = std::move(bytes);
  state_->parser = XML_ParserCreateNS(nullptr, kSeparator);
  if (state_->parser == nullptr) throw std::bad_alloc();
  XML_SetUserData(state_->parser, state_.get());
  XML_SetElementHandler(state_->parser, State::on_start, State::on_end);
  XML_SetEntityDeclHandler(state_->parser, State::on_entity);
  XML_SetStartNamespaceDeclHandler(state_->parser, State::on_namespace);
  if (wants_text) XML_SetCharacterDataHandler(state_->parser, State::on_text);
}

XmlScanner::~XmlScanner() = default;
XmlScanner::XmlScanner(XmlScanner&&) noexcept = default;

Result<const XmlEvent*> XmlScanner::next() {
  State& state = *state_;
  while (state.next == state.gathered) {
    if (state.ended) return static_cast<const XmlEvent*>(nullptr);
    state.next = state.gathered = 0;
    if (core::Status fed = state.feed(); !fed.ok()) {
      state.ended = true;
      return fed.error();
    }
  }
  const XmlEvent& event = state.events[state.next++];
  state.line = event.line;
  return &event;
}

std::string XmlScanner::namespace_of(const std::string& prefix) const {
  const auto found = state_->prefixes.find(prefix);
  return found == state_->prefixes.end() ? "" : found->second;
}

Error XmlScanner::bad(const std::string& cause) const { return state_->bad(cause); }
const std::string& XmlScanner::name() const { return state_->name; }

}  // namespace host
