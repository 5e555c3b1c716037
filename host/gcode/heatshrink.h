// Unpacks heatshrink (github.com/atomicobject/heatshrink): bits, highest first.
//
//     1 bbbbbbbb              a byte as it is
//     0 d…d c…c               c + 1 bytes from d + 1 bytes back; d has `window` bits, c `lookahead`
//
// What lies before the start counts as zeros.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace host {

struct HeatshrinkForm {
  int window;     // bits
  int lookahead;  // bits
};

// Appends `size` bytes to `into`. False: the packed bytes hold fewer. COSTS: O(size).
[[nodiscard]] bool unpack_heatshrink(std::string_view packed, HeatshrinkForm form, std::size_t size,
                                     std::string& into);

}  // namespace host
