// Reads XML's simplest elements, of which meshes have millions, without a parser of all of XML:
//
//     <vertex x="6.622" y="-1.250" z='19.689' />
//
// An element is plain if it is empty, names are of ASCII letters, digits, '.', '-' and '_', no name
// has a prefix or starts with "xmlns", no two attributes have the same name, and values are
// printable ASCII without '<', '&' and quotes. All that XML allows besides is left to others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "host/formats/xml_event.h"  // XmlEvent

namespace host {

// Attributes that a plain element may have.
inline constexpr std::size_t kPlainAttributesMax = 16;

struct PlainRead {
  enum class Outcome {
    kElement,
    kCut,    // the text ends before it is known
    kOther,  // something else follows
  };
  Outcome outcome = Outcome::kOther;
  std::size_t bytes = 0;         // to the element's end, blanks before it included
  std::int64_t lines_ahead = 0;  // line ends in the blanks before it
  std::int64_t lines = 0;        // all line ends
};

// Reads an element, after any blanks. Writes the event's name and attributes if it is one; else
// these are not to be used.
[[nodiscard]] PlainRead read_plain_element(std::string_view text, XmlEvent& event);

}  // namespace host
