#include "firmware_link/session/position_check.h"

#include <cstdlib>
#include <utility>

namespace firmware_link {
namespace {

constexpr int kDoubtsMax = 8;
constexpr std::int64_t kFilamentCount10nmMax = 10'000'000;

}  // namespace

void PositionCheck::asked(std::int64_t sequence, bool height_may_shift) {
  question_ = Question{sequence, watch_.expected(), std::nullopt};
  if (height_may_shift) question_->expected.axes_um[2].reset();
}

std::optional<std::int64_t> PositionCheck::in_flight() const {
  if (!question_) return std::nullopt;
  return question_->sequence;
}

void PositionCheck::moved_back(std::int64_t sequence) {
  if (question_ && question_->sequence == sequence) ++question_->sequence;
}

void PositionCheck::repeated_from(std::int64_t sequence) {
  if (question_ && sequence <= question_->sequence) question_->told.reset();
}

void PositionCheck::told(const Position& position) {
  if (question_) question_->told = position;
}

PositionCheck::Result PositionCheck::settle(std::int64_t acknowledged) {
  if (!question_ || acknowledged <= question_->sequence) return {};
  const Question question = *std::exchange(question_, std::nullopt);
  Result result;
  auto verdict = PositionWatch::Verdict::kAgrees;
  if (question.told) {
    result.told = true;
    verdict = PositionWatch::compare(question.expected, *question.told);
    if (verdict == PositionWatch::Verdict::kAgrees) {
      end_confirming();
      result.outcome = Outcome::kAgrees;
      return result;
    }
  }
  if (!question.told || !confirming_ || !told_last_ || !(*told_last_ == *question.told)) {
    if (++doubts_ >= kDoubtsMax) {
      end_confirming();
      result.outcome = Outcome::kUnconfirmed;
      return result;
    }
    confirming_ = true;
    told_last_ = question.told;
    result.outcome = Outcome::kAskAgain;
    return result;
  }
  end_confirming();
  if (verdict == PositionWatch::Verdict::kPositionDiffers) {
    result.outcome = Outcome::kPositionDiffers;
    result.words = "at " + PositionWatch::text_of(*question.told) + ", not " +
                   PositionWatch::text_of(question.expected);
  } else {
    result.outcome = Outcome::kFilamentDiffers;
    result.excess_10nm = PositionWatch::filament_excess_10nm(question.expected, *question.told);
  }
  return result;
}

void PositionCheck::drop() {
  question_.reset();
  end_confirming();
}

void PositionCheck::end_confirming() {
  confirming_ = false;
  told_last_.reset();
  doubts_ = 0;
}

bool PositionCheck::count_is_coarse() const {
  const auto count = watch_.expected().e_10nm;
  return count && std::abs(*count) > kFilamentCount10nmMax;
}

}  // namespace firmware_link
