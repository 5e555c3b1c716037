#include "host/pipeline/layer_draft.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>
#include <variant>

#include "firmware_link/wire/line_codec.h"  // write_fixed
#include "host/pipeline/wire_units.h"

namespace host {
namespace {

using firmware_link::Command;
using firmware_link::Move;

// After so many commands the clocks are compared.
constexpr std::array<std::size_t, 4> kMarks = {20, 40, 80, kDraftHeadMoves};

// " E-9999999.99999"
constexpr std::size_t kFilamentWordMax = 2 + 21;

// About as much as most layers need.
constexpr std::size_t kGapsOfRoad = 3, kPieceBytes = 27, kRoadBytes = 90;

// A filament that is moved alone is told whatever the rounding carries.
constexpr double kFilamentAloneMin_10nm = 2;

char* write_word(char* at, char letter, std::int64_t value, int decimals) {
  *at++ = ' ';
  *at++ = letter;
  return firmware_link::write_fixed(at, value, decimals);
}

class Drafting {
 public:
  Drafting(LayerDraft& draft, const core::LayerPlace& place, const core::LaidLayer& laid,
           const DraftStart& start)
      : draft_(draft), encoder_(start.encoder), clock_(start.clock) {
    draft.gaps.reserve(laid.pieces.size() + kGapsOfRoad * laid.roads.size());
    if (start.writer == nullptr) return;
    draft.text.reserve(kPieceBytes * laid.pieces.size() + kRoadBytes * laid.roads.size());
    writer_ = *start.writer;
    std::string unused;
    if (writer_)
      writer_->write(core::LayerStart{place.index, place.top(), place.height}, {}, unused);
  }

  // From where the print is taken to stand at the first road.
  void begin(const core::MotionState& at) {
    (void)encoder_.encode(core::Travel{at.position, 1});
    (void)encoder_.encode(core::Lift{*at.nozzle_z, 1});
    MotionEncoder::State state = encoder_.state();
    state.f_mm_min.reset();
    state.filament_rest_10nm = 0;
    encoder_.resume_from(state);
    draft_.before = state;
    clock_ = clock_.at_rest(*state.x_um, *state.y_um, *state.z_um);
    if (at.acceleration_mm_s2 > 0) {
      clock_.add_time(
          firmware_link::SetAcceleration{state.flavor, acceleration_mm_s2(at.acceleration_mm_s2)});
    }
  }

  void take(const core::Motion& motion) {
    const std::optional<Command> command = encoder_.encode(motion);
    const std::optional<double> mm = filament_mm_of(motion);
    if (std::holds_alternative<core::MoveFilament>(motion) &&
        std::abs(*mm) * kFilamentUnitsPerMm < kFilamentAloneMin_10nm) {
      possible_ = false;
    }
    if (mm) draft_.gaps.push_back({*mm * kFilamentUnitsPerMm});
    if (command && mm) {
      write_open(motion, std::get<Move>(*command));
    } else {
      write(motion, command);
    }
    if (!command) return;
    ++draft_.commands;
    count(*command, mm);
  }

  [[nodiscard]] bool finish() {
    draft_.after = encoder_.state();
    draft_.end = clock_;
    return possible_ && draft_.text.size() < LayerDraft::Gap::kNowhere;
  }

 private:
  void write(const core::Motion& motion, const std::optional<Command>& command) {
    if (!writer_) return note_feed(command);
    writer_->write(motion, command, draft_.text);
    const auto* move = command ? std::get_if<Move>(&*command) : nullptr;
    if (move == nullptr || !move->f_mm_min) return;
    // The line's last word.
    note_feed(*move->f_mm_min, draft_.text.rfind(" F"), 1);
  }

  // Without its filament, which goes before the feed.
  void write_open(const core::Motion& motion, const Move& move) {
    if (!writer_) {
      draft_.gaps.back().at = 0;
      return note_feed(Command(move));
    }
    Move open = move;
    open.e_10nm.reset();
    open.f_mm_min.reset();
    std::string& text = draft_.text;
    writer_->write(motion, Command(open), text);
    text.pop_back();
    draft_.gaps.back().at = static_cast<std::uint32_t>(text.size());
    if (move.f_mm_min) {
      std::array<char, kFilamentWordMax> word;
      const char* end = write_word(word.data(), 'F', *move.f_mm_min, 0);
      text += std::string_view(word.data(), static_cast<std::size_t>(end - word.data()));
      note_feed(*move.f_mm_min, draft_.gaps.back().at, 0);
    }
    text += '\n';
  }

  void note_feed(const std::optional<Command>& command) {
    const auto* move = command ? std::get_if<Move>(&*command) : nullptr;
    if (move != nullptr && move->f_mm_min && !draft_.feed_mm_min) {
      draft_.feed_mm_min = move->f_mm_min;
    }
  }

  // The word is the last of the text, but for so many characters.
  void note_feed(std::int64_t feed_mm_min, std::size_t at, std::size_t behind) {
    if (draft_.feed_mm_min) return;
    draft_.feed_mm_min = feed_mm_min;
    draft_.feed_at = at;
    draft_.feed_size = draft_.text.size() - behind - at;
  }

  void count(const Command& command, std::optional<double> mm) {
    clock_.add_time(command, mm);
    if (draft_.head.size() == kDraftHeadMoves) return;
    draft_.head.push_back({command, mm});
    const std::size_t size = draft_.head.size();
    if (std::find(kMarks.begin(), kMarks.end(), size) != kMarks.end()) {
      draft_.marks.push_back({size, clock_});
    }
  }

  LayerDraft& draft_;
  MotionEncoder encoder_;
  CommandClock clock_;
  std::optional<GcodeWriter> writer_;
  bool possible_ = true;
};

}  // namespace

std::optional<double> filament_mm_of(const core::Motion& motion) {
  if (const auto* extrude = std::get_if<core::Extrude>(&motion)) return extrude->filament_mm;
  if (const auto* arc = std::get_if<core::ExtrudeArc>(&motion)) return arc->filament_mm;
  if (const auto* wipe = std::get_if<core::Wipe>(&motion)) return wipe->filament_mm;
  if (const auto* alone = std::get_if<core::MoveFilament>(&motion)) return alone->filament_mm;
  return std::nullopt;
}

std::shared_ptr<const LayerDraft> draft_of(const core::Settings& settings,
                                           const core::LayerPlace& place,
                                           const core::LaidLayer& laid,
                                           const core::TravelSpace* space,
                                           const DraftStart& start) {
  if (laid.roads.empty()) return nullptr;
  const auto draft = std::make_shared<LayerDraft>();
  draft->height = place.height;
  Drafting drafting(*draft, place, laid, start);
  drafting.begin(core::state_at_first_road(settings, place, laid));
  std::optional<core::LaidBody> body = core::lay_body(
      settings, place, laid, space, [&](const core::Motion& motion) { drafting.take(motion); });
  if (!body || !drafting.finish()) return nullptr;
  draft->body = *body;
  return draft;
}

bool fits(const LayerDraft& draft, const MotionEncoder::State& now) {
  return now.x_um == draft.before.x_um && now.y_um == draft.before.y_um &&
         (!draft.body.top || now.z_um == draft.before.z_um) && now.flavor == draft.before.flavor;
}

std::optional<CommandClock> clock_behind(const LayerDraft& draft, CommandClock clock) {
  const bool any_height = !draft.body.top;
  std::size_t counted = 0;
  for (const LayerDraft::Mark& mark : draft.marks) {
    for (; counted < mark.commands; ++counted) {
      clock.add_time(draft.head[counted].command, draft.head[counted].filament_mm);
    }
    if (!clock.goes_on_as(mark.clock, any_height)) continue;
    clock.skip(mark.clock, *draft.end, any_height);
    return clock;
  }
  if (static_cast<std::size_t>(draft.commands) > draft.head.size()) return std::nullopt;
  for (; counted < draft.head.size(); ++counted) {
    clock.add_time(draft.head[counted].command, draft.head[counted].filament_mm);
  }
  return clock;
}

namespace {

// The draft's text with words put in, and the first feed's left out or not, in pieces.
class Filling {
 public:
  Filling(const LayerDraft& draft, bool feed_told,
          const std::function<bool(std::string_view)>& sink)
      : draft_(draft), feed_told_(feed_told), sink_(sink) {}

  void put(std::uint32_t at, std::int64_t filament_10nm) {
    if (draft_.text.empty()) return;
    copy_to(at);
    if (filament_10nm == 0) return;
    if (buffer_.size() - used_ < kFilamentWordMax) flush();
    const char* end = write_word(buffer_.data() + used_, 'E', filament_10nm, 5);
    used_ = static_cast<std::size_t>(end - buffer_.data());
  }

  [[nodiscard]] bool finish() {
    copy_to(draft_.text.size());
    flush();
    return goes_on_;
  }

 private:
  void copy_to(std::size_t end) {
    // Where a filament and the feed follow one another, the feed comes behind.
    if (copied_ <= draft_.feed_at && draft_.feed_at < end && draft_.feed_size > 0) {
      copy(draft_.feed_at);
      if (feed_told_) copied_ += draft_.feed_size;
    }
    copy(end);
  }

  void copy(std::size_t end) {
    while (copied_ < end) {
      if (used_ == buffer_.size()) flush();
      const std::size_t size = std::min(end - copied_, buffer_.size() - used_);
      std::memcpy(buffer_.data() + used_, draft_.text.data() + copied_, size);
      used_ += size;
      copied_ += size;
    }
  }

  void flush() {
    if (used_ > 0 && goes_on_) goes_on_ = sink_({buffer_.data(), used_});
    used_ = 0;
  }

  const LayerDraft& draft_;
  const bool feed_told_;
  const std::function<bool(std::string_view)>& sink_;
  std::size_t copied_ = 0, used_ = 0;
  bool goes_on_ = true;
  std::array<char, kDraftPieceBytes> buffer_;
};

}  // namespace

bool fill_in(const LayerDraft& draft, MotionEncoder::State& now, CommandClock& clock,
             const std::function<bool(std::string_view)>& sink) {
  Filling filling(draft, now.f_mm_min == draft.feed_mm_min, sink);
  double rest = now.filament_rest_10nm;
  for (const LayerDraft::Gap& gap : draft.gaps) {
    const double wanted = gap.filament_10nm + rest;
    rest = wanted;
    if (gap.at == LayerDraft::Gap::kNowhere) continue;
    const std::int64_t sent = std::llround(wanted);
    rest = wanted - static_cast<double>(sent);
    clock.add_filament(sent);
    filling.put(gap.at, sent);
  }
  const std::optional<std::int64_t> z_um = draft.body.top ? draft.after.z_um : now.z_um;
  now = draft.after;
  now.z_um = z_um;
  now.filament_rest_10nm = rest;
  return filling.finish();
}

}  // namespace host
