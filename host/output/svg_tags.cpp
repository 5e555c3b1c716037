#include "host/output/svg_tags.h"

#include <charconv>
#include <cstddef>

#include "core/check.h"  // RIND_CHECK

namespace host {
namespace {

constexpr std::string_view kSeparators = " ,\n";

void skip_separators(std::string_view& text) {
  while (!text.empty() && kSeparators.find(text.front()) != std::string_view::npos)
    text.remove_prefix(1);
}

SvgTag tag_of(std::string_view inside) {
  SvgTag tag;
  tag.closed = inside.ends_with('/');
  if (tag.closed) inside.remove_suffix(1);
  tag.name = inside.substr(0, inside.find(' '));
  inside.remove_prefix(tag.name.size());
  while (true) {
    skip_separators(inside);
    const std::size_t equals = inside.find('=');
    if (equals == std::string_view::npos) return tag;
    const std::size_t end = inside.find('"', equals + 2);
    RIND_CHECK(end != std::string_view::npos);
    tag.attributes[inside.substr(0, equals)] = inside.substr(equals + 2, end - equals - 2);
    inside.remove_prefix(end + 1);
  }
}

}  // namespace

std::vector<SvgTag> svg_tags(std::string_view svg) {
  std::vector<SvgTag> tags;
  std::size_t at = svg.find('<');
  while (at != std::string_view::npos) {
    const std::size_t end = svg.find('>', at);
    RIND_CHECK(end != std::string_view::npos);
    const std::size_t next = svg.find('<', end);
    tags.push_back(tag_of(svg.substr(at + 1, end - at - 1)));
    tags.back().text = svg.substr(end + 1, next == std::string_view::npos ? 0 : next - end - 1);
    at = next;
  }
  return tags;
}

bool has_number(std::string_view text) {
  skip_separators(text);
  const auto begins = [](char c) { return (c >= '0' && c <= '9') || c == '-' || c == '.'; };
  return !text.empty() && begins(text.front());
}

double take_number(std::string_view& text) {
  skip_separators(text);
  double number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  RIND_CHECK(read.ec == std::errc());
  text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
  skip_separators(text);
  return number;
}

std::vector<SvgLine> svg_lines(std::string_view data) {
  std::vector<SvgLine> lines;
  Pixel at, start;
  char letter = 'M';
  while (true) {
    skip_separators(data);
    if (data.empty()) return lines;
    if (!has_number(data)) {
      letter = data.front();
      data.remove_prefix(1);
      if (letter == 'z' || letter == 'Z') {
        lines.back().closed = true;
        at = start;
        continue;
      }
    }
    const bool relative = letter >= 'a';
    const Pixel from = relative ? at : Pixel{};
    const char kind = relative ? static_cast<char>(letter - 'a' + 'A') : letter;
    RIND_CHECK(kind == 'M' || kind == 'L' || kind == 'H' || kind == 'V');
    if (kind != 'V') at.x = from.x + take_number(data);
    if (kind != 'H') at.y = from.y + take_number(data);
    if (kind == 'M') {
      start = at;
      lines.emplace_back();
    } else if (lines.empty() || lines.back().closed) {
      lines.push_back({{start}, false});
    }
    lines.back().points.push_back(at);
  }
}

std::string unescaped(std::string_view text) {
  struct Entity {
    std::string_view name;
    char letter;
  };
  constexpr Entity kEntities[] = {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}};
  std::string out;
  while (!text.empty()) {
    std::size_t taken = 1;
    char letter = text.front();
    for (const Entity& entity : kEntities) {
      if (!text.starts_with(entity.name)) continue;
      taken = entity.name.size();
      letter = entity.letter;
    }
    out += letter;
    text.remove_prefix(taken);
  }
  return out;
}

}  // namespace host
