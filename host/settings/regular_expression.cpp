#include "host/settings/regular_expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <bitset>
#include <climits>
#include <utility>
#include <vector>

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;

// Groups within groups.
constexpr int kGroupsMax = 32;

using Characters = std::bitset<UCHAR_MAX + 1>;

// A state of the automaton: it takes one of `characters` and goes to `next`, or goes to both next
// states without taking any.
struct State {
  bool takes = false;
  Characters characters;
  std::size_t next = 0;
  std::size_t other = 0;
};

// Jumps count from its first state. What is behind it has the number of its states.
struct Piece {
  std::vector<State> states;
};

State jump(std::size_t next, std::size_t other) { return {false, {}, next, other}; }

void append(Piece& whole, Piece part) {
  const std::size_t base = whole.states.size();
  for (State& state : part.states) {
    state.next += base;
    state.other += base;
    whole.states.push_back(state);
  }
}

// a|b: to both; behind a, past b.
Piece either(Piece a, Piece b) {
  Piece whole;
  const std::size_t behind_a = a.states.size() + 2, behind_b = behind_a + b.states.size();
  whole.states.push_back(jump(1, behind_a));
  append(whole, std::move(a));
  whole.states.push_back(jump(behind_b, behind_b));
  append(whole, std::move(b));
  return whole;
}

// a*, a+ or a?.
Piece repeated(Piece a, char how) {
  Piece whole;
  const std::size_t length = a.states.size();
  if (how != '+') whole.states.push_back(jump(1, length + (how == '*' ? 2 : 1)));
  const std::size_t first = whole.states.size();
  append(whole, std::move(a));
  const std::size_t behind = whole.states.size() + 1;
  if (how != '?') whole.states.push_back(jump(first, behind));
  return whole;
}

class Pattern {
 public:
  explicit Pattern(std::string_view text) : text_(text) {}

  Result<Piece> parse() {
    if (text_.starts_with('^')) ++at_;
    Result<Piece> all = alternatives();
    if (all.ok() && at_ < text_.size()) return bad("a ) too many");
    return all;
  }

 private:
  [[nodiscard]] bool done() const { return at_ == text_.size(); }

  static Error bad(std::string_view cause) {
    return {ErrorCode::kBadSetting, fmt::format("regular expression: {}", cause)};
  }

  Result<Piece> alternatives() {
    if (++depth_ > kGroupsMax) return bad("groups are nested too deep");
    Result<Piece> whole = sequence();
    while (whole.ok() && !done() && text_[at_] == '|') {
      ++at_;
      Result<Piece> other = sequence();
      if (!other.ok()) return other;
      whole = either(std::move(whole).value(), std::move(other).value());
    }
    --depth_;
    return whole;
  }

  Result<Piece> sequence() {
    Piece whole;
    while (!done() && text_[at_] != '|' && text_[at_] != ')') {
      if (text_[at_] == '$' && at_ + 1 == text_.size()) {
        ++at_;
        break;
      }
      Result<Piece> one = single();
      if (!one.ok()) return one;
      Piece piece = std::move(one).value();
      while (!done() && (text_[at_] == '*' || text_[at_] == '+' || text_[at_] == '?')) {
        piece = repeated(std::move(piece), text_[at_++]);
      }
      append(whole, std::move(piece));
    }
    return whole;
  }

  Result<Piece> single() {
    const char c = text_[at_++];
    if (c == '(') {
      if (text_.substr(at_).starts_with("?:")) at_ += 2;
      Result<Piece> group = alternatives();
      if (!group.ok()) return group;
      if (done()) return bad("a ( is not closed");
      ++at_;
      return group;
    }
    Characters characters;
    if (c == '.') {
      characters.set();
    } else if (c == '[') {
      if (Status read = read_class(characters); !read.ok()) return read.error();
    } else if (c == '\\') {
      if (done()) return bad("a character is missing behind the last \\");
      add_escaped(text_[at_++], characters);
    } else if (c == '*' || c == '+' || c == '?' || c == '{') {
      return bad(fmt::format("{} is not understood here", c));
    } else {
      characters.set(static_cast<unsigned char>(c));
    }
    return Piece{{State{true, characters, 1, 1}}};
  }

  static void add_range(unsigned char from, unsigned char to, Characters& into) {
    for (unsigned c = from; c <= to; ++c) into.set(c);
  }

  static void add_escaped(char c, Characters& into) {
    if (c == 'd' || c == 'w') add_range('0', '9', into);
    if (c == 'w') {
      add_range('a', 'z', into);
      add_range('A', 'Z', into);
      into.set('_');
    }
    if (c == 's') {
      for (const char space : std::string_view(" \t\r\n\v\f")) {
        into.set(static_cast<unsigned char>(space));
      }
    }
    if (c == 'n') into.set('\n');
    if (std::string_view("dwsn").find(c) == std::string_view::npos) {
      into.set(static_cast<unsigned char>(c));
    }
  }

  Status read_class(Characters& into) {
    const bool all_but = !done() && text_[at_] == '^';
    if (all_but) ++at_;
    for (bool first = true;; first = false) {
      if (done()) return bad("a [ is not closed");
      const char c = text_[at_++];
      if (c == ']' && !first) break;
      if (c == '\\' && !done()) {
        add_escaped(text_[at_++], into);
      } else if (text_.substr(at_).starts_with('-') && at_ + 1 < text_.size() &&
                 text_[at_ + 1] != ']') {
        add_range(static_cast<unsigned char>(c), static_cast<unsigned char>(text_[at_ + 1]), into);
        at_ += 2;
      } else {
        into.set(static_cast<unsigned char>(c));
      }
    }
    if (all_but) into.flip();
    return {};
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

// Marks the states that are reached without taking a character.
void reach(const std::vector<State>& states, std::size_t from, std::vector<bool>& reached) {
  std::vector<std::size_t> open = {from};
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    if (reached[at]) continue;
    reached[at] = true;
    if (at == states.size() || states[at].takes) continue;
    open.push_back(states[at].next);
    open.push_back(states[at].other);
  }
}

}  // namespace

Result<bool> matches_whole(std::string_view pattern, std::string_view text) {
  if (pattern.size() > kPatternBytesMax || text.size() > kMatchedBytesMax) {
    return Error{ErrorCode::kBadSetting,
                 fmt::format("regular expression: it has more than {} bytes, or its text more than "
                             "{}",
                             kPatternBytesMax, kMatchedBytesMax)};
  }
  const Result<Piece> parsed = Pattern(pattern).parse();
  if (!parsed.ok()) return parsed.error();
  const std::vector<State>& states = parsed.value().states;
  std::vector<bool> now(states.size() + 1);
  reach(states, 0, now);
  for (const char c : text) {
    std::vector<bool> next(states.size() + 1);
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (now[i] && states[i].takes && states[i].characters[static_cast<unsigned char>(c)]) {
        reach(states, states[i].next, next);
      }
    }
    now = std::move(next);
  }
  return static_cast<bool>(now.back());
}

}  // namespace host
