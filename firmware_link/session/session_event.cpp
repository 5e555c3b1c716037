#include "firmware_link/session/session_event.h"

namespace firmware_link {

SessionEvent::Kind kind_of_action(std::string_view action) {
  using Kind = SessionEvent::Kind;
  struct Known {
    std::string_view action;
    Kind kind;
  };
  constexpr Known kKnown[] = {{"pause", Kind::kPauseAsked},
                              {"resume", Kind::kResumeAsked},
                              {"cancel", Kind::kCancelAsked},
                              {"paused", Kind::kPaused},
                              {"resumed", Kind::kResumed}};
  for (const Known& known : kKnown) {
    if (action == known.action) return known.kind;
  }
  return Kind::kAction;
}

}  // namespace firmware_link
