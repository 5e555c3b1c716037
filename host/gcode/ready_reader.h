// Reads a ready G-code file command for command, and knows at each where in the print it stands.
//
//     GcodeText ──> GcodeLines ──> meaning_of() ──> ReadyCommand
//                       └── comments: layers
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "core/result.h"              // Result
#include "host/gcode/file_place.h"    // FilePlace
#include "host/gcode/gcode_lines.h"   // GcodeLines
#include "host/gcode/gcode_text.h"    // GcodeText
#include "host/gcode/line_meaning.h"  // LineMeaning, MeaningRules
#include "host/gcode/set_up_lines.h"  // SetUpLines

namespace host {

// Where no comment tells of layers, one starts where a road is laid so much above the last.
inline constexpr std::int64_t kLayerStepUm = 40;

struct ReadyCommand {
  LineMeaning meaning;
  std::int64_t line_number = 0;
  bool lays_road = false;
  double way_seconds = 0;  // of this command's move, at full speed
};

class ReadyReader {
 public:
  // `marks`: comments tell where layers start. The text outlives the reader; its next piece is that
  // of `from`.
  ReadyReader(GcodeText& text, MeaningRules rules, bool marks, FilePlace from = {});

  // nullopt at the end. Errors: those of the text; a line that can't be sent, with its number.
  [[nodiscard]] core::Result<std::optional<ReadyCommand>> next();

  // How everything stands behind the command that next() gave last, but for what is set up. Its
  // text is still that command's.
  [[nodiscard]] const FilePlace& behind() const { return place_; }
  // How it stood before that command; but what this sets up is set up already.
  [[nodiscard]] FilePlace before() const;

  // Called with each comment. May be empty.
  std::function<void(std::string_view)> on_comment;

 private:
  void note(ReadyCommand& command);

  MeaningRules rules_;
  bool marks_;
  GcodeLines lines_;
  SetUpLines set_up_;
  FilePlace place_;
  FilePlace before_;
};

}  // namespace host
