// The lines of a file that set the controller up and move nothing: M204, M900, M220,
// SET_PRESSURE_ADVANCE … A controller that was reset is told them again.
//
//     M204 P800       one line for each command: later values take the place of earlier ones,
//     M204 T1500      and others stay                                   -> M204 P800 T1500
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace host {

// All lines together. More are not kept: the file is not resumed after a reset then.
inline constexpr std::size_t kSetUpBytesMax = 2'048;

// Whether the command, in canonical form (gcode_words.h), is one of these.
[[nodiscard]] bool sets_up(std::string_view command);

class SetUpLines {
 public:
  SetUpLines() = default;
  // What text() told.
  explicit SetUpLines(std::string_view text);

  // REQUIRES: sets_up() of its command; no comment.
  void add(std::string_view line);

  // One line each, with its end. Empty: there are none.
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] std::vector<std::string> lines() const;

  // Some did not fit.
  [[nodiscard]] bool left_out() const { return left_out_; }

 private:
  std::string text_;
  bool left_out_ = false;
};

}  // namespace host
