#include "host/formats/plain_element.h"

#include <array>

namespace host {
namespace {

enum Class : std::uint8_t { kName = 1, kNameStart = 2, kValue = 4, kBlank = 8 };

constexpr std::array<std::uint8_t, 256> classes() {
  std::array<std::uint8_t, 256> table{};
  for (std::size_t c = 0x20; c < 0x7F; ++c) {
    if (c != '<' && c != '&' && c != '"' && c != '\'') table[c] |= kValue;
  }
  for (std::size_t c = 'a'; c <= 'z'; ++c) table[c] |= kName | kNameStart;
  for (std::size_t c = 'A'; c <= 'Z'; ++c) table[c] |= kName | kNameStart;
  for (std::size_t c = '0'; c <= '9'; ++c) table[c] |= kName;
  for (const std::size_t c : std::array<std::size_t, 3>{'.', '-', '_'}) table[c] |= kName;
  table['_'] |= kNameStart;
  for (const std::size_t c : std::array<std::size_t, 3>{' ', '\t', '\n'}) table[c] |= kBlank;
  return table;
}
constexpr std::array<std::uint8_t, 256> kClasses = classes();

class Reader {
 public:
  using Outcome = PlainRead::Outcome;

  explicit Reader(std::string_view text)
      : at_(text.data()), end_(text.data() + text.size()), start_(at_) {}

  [[nodiscard]] PlainRead read(XmlEvent& event) {
    PlainRead result;
    result.outcome = element(event, result.lines_ahead);
    result.bytes = static_cast<std::size_t>(at_ - start_);
    result.lines = lines_;
    return result;
  }

 private:
  [[nodiscard]] Outcome element(XmlEvent& event, std::int64_t& lines_ahead) {
    if (!skip_blanks()) return missed();
    lines_ahead = lines_;
    if (!take('<')) return missed();
    const std::string_view name = take_name();
    if (name.empty()) return missed();
    event.name.assign(name);
    std::size_t count = 0;
    while (true) {
      const char* before = at_;
      if (!skip_blanks()) return missed();
      if (*at_ == '/') break;
      if (at_ == before || count == kPlainAttributesMax) return Outcome::kOther;
      if (count == event.attributes.size()) event.attributes.emplace_back();
      if (!attribute(event, count)) return missed();
      ++count;
    }
    ++at_;
    if (!take('>')) return missed();
    event.attributes.resize(count);
    return Outcome::kElement;
  }

  // Also why a call has failed.
  [[nodiscard]] Outcome missed() const { return at_ == end_ ? Outcome::kCut : Outcome::kOther; }

  [[nodiscard]] bool attribute(XmlEvent& event, std::size_t number) {
    const std::string_view name = take_name();
    if (name.empty() || name.starts_with("xmlns")) return false;
    for (std::size_t i = 0; i < number; ++i) {
      if (event.attributes[i].first == name) return false;
    }
    if (!take('=') || at_ == end_ || (*at_ != '"' && *at_ != '\'')) return false;
    const char quote = *at_++;
    const char* value = at_;
    skip(kValue);
    if (at_ == end_ || *at_ != quote) return false;
    event.attributes[number].first.assign(name);
    event.attributes[number].second.assign(value, at_);
    ++at_;
    return true;
  }

  [[nodiscard]] bool is(std::uint8_t wanted) const {
    return (kClasses[static_cast<unsigned char>(*at_)] & wanted) != 0;
  }

  void skip(std::uint8_t wanted) {
    while (at_ != end_ && is(wanted)) ++at_;
  }

  [[nodiscard]] bool take(char wanted) {
    if (at_ == end_ || *at_ != wanted) return false;
    ++at_;
    return true;
  }

  // Empty if there is none, or if it may go on.
  [[nodiscard]] std::string_view take_name() {
    const char* name = at_;
    if (at_ == end_ || !is(kNameStart)) return {};
    skip(kName);
    if (at_ == end_) return {};
    return {name, static_cast<std::size_t>(at_ - name)};
  }

  // False if the text ends.
  [[nodiscard]] bool skip_blanks() {
    for (; at_ != end_; ++at_) {
      if (*at_ == '\n') {
        ++lines_;
      } else if (*at_ == '\r') {
        if (at_ + 1 == end_) return at_ = end_, false;
        if (at_[1] != '\n') return true;  // a line end of its own; nobody writes that
      } else if (!is(kBlank)) {
        return true;
      }
    }
    return false;
  }

  const char* at_;
  const char* end_;
  const char* start_;
  std::int64_t lines_ = 0;
};

}  // namespace

PlainRead read_plain_element(std::string_view text, XmlEvent& event) {
  return Reader(text).read(event);
}

}  // namespace host
