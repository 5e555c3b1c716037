// How long a nozzle that has laid roads, and was not told to cool down, has nothing to do: there it
// stands on the part.
#pragma once

#include <algorithm>
#include <optional>

#include "firmware_link/wire/instant.h"  // Instant

namespace firmware_link {

class VirtualStanding {
 public:
  void laid() { laid_ = true; }
  void cooled() { laid_ = false; }

  // Looks at it now. `busy`: it moves, has a command, or has halted.
  void look(bool busy, Instant now) {
    if (!laid_ || busy) {
      since_.reset();
      return;
    }
    if (!since_) since_ = now;
    longest_ = std::max(longest_, now - *since_);
  }

  [[nodiscard]] Duration longest() const { return longest_; }

 private:
  bool laid_ = false;
  std::optional<Instant> since_;
  Duration longest_{0};
};

}  // namespace firmware_link
