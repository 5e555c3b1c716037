#include "host/formats/xml_scanner.h"

#include <expat.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>

#include "host/formats/format_limits.h"  // kNestingMax, kXmlTokenBytesMax
#include "host/formats/plain_element.h"  // read_plain_element

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
// A list's tag that is longer is read as any other.
constexpr std::size_t kTagBytes = 1'024;

}  // namespace

// Events of what was fed last, collected by expat's callbacks; their memory is reused.
//
//     bytes ──> [ unread ] ──> expat ──> events
//                   └── plain elements of a list ──> plain
//
// Plain elements are cut out of what expat sees: as they are empty, nothing else depends on them.
// A list begins with a tag at whose end expat stands, with nothing left to decide.
struct XmlScanner::State {
  std::string name;
  ByteSource bytes;
  XML_Parser parser = nullptr;
  std::array<char, kPieceBytes> piece{};
  std::size_t begin = 0, end = 0;  // unread
  bool input_ended = false;
  std::vector<XmlEvent> events;
  std::size_t gathered = 0;
  std::size_t next = 0;
  std::int64_t fed_bytes = 0;
  std::int64_t token_end = 0;  // of the last event, counted as fed_bytes
  int depth = 0;
  bool ended = false;
  std::int64_t line = 1;
  std::map<std::string, std::string> prefixes;
  std::string refusal;  // why a callback stopped the parser

  std::vector<std::string> lists;  // starts of their tags: "<vertices"
  std::int64_t list_tag = -1;      // where such a tag was fed, counted as fed_bytes
  int list_depth = 0;              // of the list that was begun; 0: none
  XmlEvent plain;
  bool after_return = false;                     // what was fed last
  std::int64_t lines_passed = 0, lines_cut = 0;  // line ends fed or cut; cut

  ~State() {
    if (parser != nullptr) XML_ParserFree(parser);
  }

  XmlEvent& add(XmlEvent::Kind kind) {
    if (gathered == events.size()) events.emplace_back();
    XmlEvent& event = events[gathered++];
    event.kind = kind;
    event.space.clear();
    event.name.clear();
    event.line = line_of(parser) + lines_cut;
    token_end = byte_of(parser) + XML_GetCurrentByteCount(parser);
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
    const bool list = !state.lists.empty() && byte_of(state.parser) == state.list_tag;
    if (!list || state.list_depth > 0) return;
    state.list_depth = state.depth;
    state.plain.space = event.space;
  }

  static void on_end(void* data, const char* name) {
    State& state = of(data);
    if (--state.depth < state.list_depth) state.list_depth = 0;
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

  // It may give attributes that are not written.
  static void on_doctype(void* data, const char*, const char*, const char*, int) {
    of(data).lists.clear();
  }

  static void on_entity(void* data, const char*, int, const char*, int, const char*, const char*,
                        const char*, const char*) {
    of(data).refuse("the document declares entities, which is refused; export the file again");
  }

  [[nodiscard]] Error bad(const std::string& cause) const {
    return {ErrorCode::kBadPart, name + ": line " + std::to_string(line) + ": " + cause};
  }

  // Reads more behind what is unread. REQUIRES: there is room.
  [[nodiscard]] core::Status refill() {
    std::copy(piece.begin() + static_cast<std::ptrdiff_t>(begin),
              piece.begin() + static_cast<std::ptrdiff_t>(end), piece.begin());
    end -= begin;
    begin = 0;
    const Result<std::size_t> count = bytes(piece.data() + end, piece.size() - end);
    if (!count.ok()) return count.error();
    input_ended = count.value() == 0;
    end += count.value();
    return {};
  }
  [[nodiscard]] bool can_refill() const { return !input_ended && end - begin < piece.size(); }

  [[nodiscard]] std::string_view unread() const { return {piece.data() + begin, end - begin}; }

  // Where what is fed next ends: behind a list's tag, or the next tag in a list. 0: more has to be
  // read first.
  [[nodiscard]] std::size_t to_feed() {
    const std::string_view text = unread();
    if (lists.empty()) return text.size();
    if (list_depth > 0) return std::min(text.find('>'), text.size() - 1) + 1;
    std::size_t tag = std::string_view::npos;
    for (const std::string& list : lists) tag = std::min(tag, text.find(list));
    const std::size_t tag_end = tag == std::string_view::npos ? tag : text.find('>', tag);
    if (tag_end != std::string_view::npos) {
      list_tag = fed_bytes + static_cast<std::int64_t>(tag);
      return tag_end + 1;
    }
    // A tag that is not complete is looked at again.
    const std::size_t last = text.rfind('<');
    const bool open = last != std::string_view::npos && text.find('>', last) == text.npos;
    return open && can_refill() && text.size() - last < kTagBytes ? last : text.size();
  }

  // As XML counts them: \r\n is one line end.
  void count_lines(std::string_view text) {
    for (const char c : text) {
      if (c == '\r' || (c == '\n' && !after_return)) ++lines_passed;
      after_return = c == '\r';
    }
  }

  // Feeds one more piece.
  [[nodiscard]] core::Status feed() {
    std::size_t count = begin == end ? 0 : to_feed();
    if (count == 0 && can_refill()) {
      if (core::Status filled = refill(); !filled.ok()) return filled;
      if (!input_ended) return {};
      count = end - begin;
    }
    const std::string_view text = unread().substr(0, count);
    begin += count;
    ended = count == 0;
    fed_bytes += static_cast<std::int64_t>(count);
    if (!lists.empty()) count_lines(text);
    const XML_Status status =
        XML_Parse(parser, text.data(), static_cast<int>(count), ended ? 1 : 0);
    if (status == XML_STATUS_OK) {
      const std::int64_t waiting = fed_bytes - byte_of(parser);
      if (waiting <= kXmlTokenBytesMax || ended) return {};
      refusal = "a tag or text of more than " + std::to_string(kXmlTokenBytesMax) +
                " bytes, more than fits; export the file again";
    }
    line = line_of(parser) + lines_cut;
    if (!refusal.empty()) return bad(refusal);
    const XML_Error code = XML_GetErrorCode(parser);
    if (ended) {
      return bad(std::string("the document ends early (") + XML_ErrorString(code) +
                 "): it is cut short; copy or export it again");
    }
    return bad(std::string("no XML: ") + XML_ErrorString(code) + "; export the file again");
  }

  // The next element of a list, if it is plain.
  [[nodiscard]] Result<bool> take_plain() {
    while (list_depth > 0 && depth == list_depth && token_end == fed_bytes) {
      const PlainRead read = read_plain_element(unread(), plain);
      if (read.outcome == PlainRead::Outcome::kCut && can_refill()) {
        if (core::Status filled = refill(); !filled.ok()) return filled.error();
        continue;
      }
      if (read.outcome != PlainRead::Outcome::kElement) return false;
      plain.line = 1 + lines_passed + read.lines_ahead;
      begin += read.bytes;
      lines_passed += read.lines;
      lines_cut += read.lines;
      return true;
    }
    return false;
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
  XML_SetStartDoctypeDeclHandler(state_->parser, State::on_doctype);
  if (wants_text) XML_SetCharacterDataHandler(state_->parser, State::on_text);
}

XmlScanner::~XmlScanner() = default;
XmlScanner::XmlScanner(XmlScanner&&) noexcept = default;

Result<const XmlEvent*> XmlScanner::next() {
  State& state = *state_;
  while (state.next == state.gathered) {
    const Result<bool> plain = state.take_plain();
    if (!plain.ok()) {
      state.ended = true;
      return plain.error();
    }
    if (plain.value()) {
      state.line = state.plain.line;
      return &state.plain;
    }
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

void XmlScanner::expect_lists(std::vector<std::string> names) {
  for (std::string& name : names) state_->lists.push_back("<" + std::move(name));
}

std::string XmlScanner::namespace_of(const std::string& prefix) const {
  const auto found = state_->prefixes.find(prefix);
  return found == state_->prefixes.end() ? "" : found->second;
}

Error XmlScanner::bad(const std::string& cause) const { return state_->bad(cause); }
const std::string& XmlScanner::name() const { return state_->name; }

}  // namespace host
