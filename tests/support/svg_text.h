// How tests look at SVG: as text, without any of what writes it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace test {

inline std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
    ++found;
  }
  return found;
}

// Empty where every tag is closed in its turn, every quote ends and every & begins an entity; else
// what is wrong.
inline std::string svg_fault(const std::string& svg) {
  std::vector<std::string> open;
  for (std::size_t at = 0; at < svg.size(); ++at) {
    if (svg[at] == '&') {
      const std::string entity = svg.substr(at, svg.find(';', at) - at + 1);
      if (entity != "&amp;" && entity != "&lt;" && entity != "&gt;") return "bare & at " + entity;
    }
    if (svg[at] == '>') return "bare > after " + svg.substr(0, at);
    if (svg[at] != '<') continue;
    std::size_t end = at + 1;
    for (bool quoted = false; end < svg.size() && (quoted || svg[end] != '>'); ++end) {
      if (svg[end] == '"') quoted = !quoted;
      if (svg[end] == '<') return "< within a tag";
    }
    if (end == svg.size()) return "a tag does not end";
    const std::string tag = svg.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(0, tag.find(' '));
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return "closes what is not open: " + tag;
      open.pop_back();
    } else if (tag.back() != '/') {
      if (open.empty() && at != 0) return "a second root: " + tag;
      open.push_back(name);
    }
    at = end;
  }
  return open.empty() ? "" : "not closed: " + open.back();
}

// Numbers that are no numbers.
inline bool has_odd_number(const std::string& svg) {
  return count(svg, "nan") + count(svg, "inf ") + count(svg, "-inf") + count(svg, "e+") != 0;
}

}  // namespace test
