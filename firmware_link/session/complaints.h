// Which of a controller's complaints are worth telling a person: not those that the link has
// mended, and not the answer to what is left of a damaged line.
//
//     "Error:…" ──Resend, refused──> mended: counted        "Unknown command: …"
//        └──ok──> it stands: told                              sent lately? told : counted
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "firmware_link/session/send_window.h"  // SendWindow
#include "firmware_link/wire/reply.h"           // Reply

namespace firmware_link {

class Complaints {
 public:
  enum class Fate { kTell, kCount, kHold };

  // A complaint came. Without line numbers (`numbered` is false) each one is told.
  [[nodiscard]] Fate heard(const Reply& reply, const SendWindow& window, bool numbered);

  // A request to repeat a line came: true when a complaint was held, which was its reason.
  [[nodiscard]] bool mended();
  // An `ok` came: the complaint that was held, if any.
  [[nodiscard]] std::optional<std::string> stands();

  // What the controller said when it last refused something.
  void refused(std::string_view words) { last_refusal_ = std::string(words); }
  [[nodiscard]] const std::string& last_refusal() const { return last_refusal_; }

 private:
  std::optional<std::string> held_;
  std::string last_refusal_;
};

// Whether the words quote a command ('Unknown command:"E0"') that no line in flight starts with.
// Where lines carry no checksum, such a line was damaged on its way.
[[nodiscard]] bool quotes_what_was_not_sent(std::string_view words, const SendWindow& window);

}  // namespace firmware_link
