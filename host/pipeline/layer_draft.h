// A layer's roads as commands and text, made in any thread before the layer's turn, but for what
// only its turn tells: the filament of each move, whose rounding carries over from move to move.
//
//     body      core's motions, from where the first road starts (core/motions/laid_body.h)
//     text      "G1 X10.5 Y3 ⟨E⟩ F1200\n…"        gaps: where each E goes
//     clock     the time, counted from rest; in its turn the first moves are counted again, until
//               the clock goes on as this one did (core/motions/motion_clock.h)
//
// Layers of the same roads share it. In its turn it is given out if the print stands as it takes it
// to stand; otherwise the layer is made anew. So the commands are the same either way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motions/laid_body.h"        // LaidBody
#include "core/units.h"                    // Length
#include "firmware_link/wire/command.h"    // Command
#include "host/gcode/command_clock.h"      // CommandClock
#include "host/output/gcode_writer.h"      // GcodeWriter
#include "host/pipeline/motion_encoder.h"  // MotionEncoder

namespace host {

// Moves of a draft that are kept to be counted again.
inline constexpr std::size_t kDraftHeadMoves = 160;

// Of text that is given on at once.
inline constexpr std::size_t kDraftPieceBytes = std::size_t{16} * 1'024;

struct LayerDraft {
  core::LaidBody body;
  core::Length height;  // of the layer

  MotionEncoder::State before, after;  // but for filament; before: feed not known
  std::int64_t commands = 0;

  // Each motion's filament, and where its word goes into the text.
  struct Gap {
    static constexpr std::uint32_t kNowhere = 0xffffffff;  // it is told with the next one's

    double filament_10nm = 0;
    std::uint32_t at = kNowhere;
  };
  std::vector<Gap> gaps;
  std::string text;
  // The first feed's word in the text, left out where the feed is that already.
  std::size_t feed_at = 0, feed_size = 0;
  std::optional<std::int64_t> feed_mm_min;

  struct Step {
    firmware_link::Command command;
    std::optional<double> filament_mm;
  };
  std::vector<Step> head;  // the first commands, kDraftHeadMoves at most
  struct Mark {
    std::size_t commands = 0;  // so many of the head
    CommandClock clock;
  };
  std::vector<Mark> marks;
  std::optional<CommandClock> end;
};

// What the motion pushes, or, negative, draws back; nothing: it leaves the filament alone.
[[nodiscard]] std::optional<double> filament_mm_of(const core::Motion& motion);

// What a draft starts from.
struct DraftStart {
  const MotionEncoder& encoder;         // flavor, origin and labels count
  const CommandClock& clock;            // what was told about moving counts
  const GcodeWriter* writer = nullptr;  // null: no text is wanted
};

// Nothing where a layer's turn alone tells how it is laid. COSTS: as core::lay_body(), and O(n) for
// its motions; holds their text, 16 bytes for each, and kDraftHeadMoves commands.
[[nodiscard]] std::shared_ptr<const LayerDraft> draft_of(const core::Settings& settings,
                                                         const core::LayerPlace& place,
                                                         const core::LaidLayer& laid,
                                                         const core::TravelSpace* space,
                                                         const DraftStart& start);

// Whether an encoder in this state goes on with the draft's commands.
[[nodiscard]] bool fits(const LayerDraft& draft, const MotionEncoder::State& now);

// The clock behind the draft, but for the filament; nothing: it does not come to go on as the
// draft's. COSTS: O(kDraftHeadMoves · core::kLookAheadMoves).
[[nodiscard]] std::optional<CommandClock> clock_behind(const LayerDraft& draft, CommandClock clock);

// Fills in the filament: gives the text to the sink, in pieces of kDraftPieceBytes, tells the
// clock, and puts the encoder to where the commands leave it. False: the sink wants no more.
// REQUIRES: fits(draft, now). COSTS: O(n).
[[nodiscard]] bool fill_in(const LayerDraft& draft, MotionEncoder::State& now, CommandClock& clock,
                           const std::function<bool(std::string_view)>& sink);

}  // namespace host
