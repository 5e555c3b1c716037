#include "host/formats/threemf_slices.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "core/check.h"                     // RIND_CHECK
#include "core/units.h"                     // Length
#include "host/formats/contour_gatherer.h"  // ContourGatherer
#include "host/formats/number_text.h"       // number_text

namespace host {
namespace {

using core::Length;
using core::Result;
using core::Slice;
using core::Status;

// Difference between equal heights that were rounded to the grid separately.
constexpr std::int64_t kSameHeightUnits = 1;

bool same_height(std::int64_t a, std::int64_t b) { return std::abs(a - b) <= kSameHeightUnits; }

std::string mm_text(std::int64_t units) { return number_text(Length::from_units(units).mm()); }

class SlicesReader : public LayerReader {
 public:
  explicit SlicesReader(ZipArchive archive) : archive_(std::move(archive)) {}

  [[nodiscard]] std::string format() const override { return "3MF slices"; }

  [[nodiscard]] Status open(std::vector<SlicedItem> items) {
    for (SlicedItem& item : items) {
      auto stack = std::make_unique<SliceStack>(archive_, std::move(item));
      const Result<bool> first = stack->advance();
      if (!first.ok()) return first.error();
      if (first.value()) stacks_.push_back(std::move(stack));
    }
    return {};
  }

  [[nodiscard]] Result<std::optional<Slice>> next() override {
    if (stacks_.empty()) return std::optional<Slice>();
    const Result<Slice> gathered = layer();
    if (!gathered.ok()) return gathered.error();
    for (auto& stack : stacks_) {
      if (stack->top() > top_ + kSameHeightUnits) continue;
      const Result<bool> more = stack->advance();
      if (!more.ok()) return more.error();
      if (stack->left_polygons_out() && !std::exchange(told_, true)) {
        warn(archive_.name() + ": polygons that stay open were left out");
      }
      if (!more.value()) stack.reset();
    }
    std::erase(stacks_, nullptr);
    return std::optional<Slice>(gathered.value());
  }

 private:
  // The union of all stacks at the lowest next height.
  [[nodiscard]] Result<Slice> layer() {
    const SliceStack& lowest =
        **std::min_element(stacks_.begin(), stacks_.end(),
                           [](const auto& a, const auto& b) { return a->bottom() < b->bottom(); });
    const std::int64_t bottom = index_ > 0 ? top_ : lowest.bottom(), top = lowest.top();
    if (!same_height(lowest.bottom(), bottom)) {
      return lowest.bad("there is no slice between " + mm_text(bottom) + " and " +
                        mm_text(lowest.bottom()) + " mm; export the part again");
    }
    for (const auto& stack : stacks_) {
      const bool here = same_height(stack->bottom(), bottom) && same_height(stack->top(), top);
      const bool above = stack->bottom() >= top - kSameHeightUnits;
      if (!here && !above) {
        return stack->bad("a slice from " + mm_text(stack->bottom()) + " to " +
                          mm_text(stack->top()) + " mm beside one from " + mm_text(bottom) +
                          " to " + mm_text(top) +
                          " mm: items with other layers can't be one print; slice them alike, or "
                          "print one at a time");
      }
      if (!here) continue;
      if (const std::string cause = together_.add(stack->take_region()); !cause.empty()) {
        return stack->bad(cause);
      }
    }
    if (top <= bottom) return lowest.bad("a slice without height; export the part again");
    top_ = top;
    Slice slice;
    slice.index = index_++;
    slice.bottom = Length::from_units(bottom);
    slice.height = Length::from_units(top - bottom);
    slice.region = together_.take(core::FillRule::kPositive);
    return slice;
  }

  ZipArchive archive_;
  std::vector<std::unique_ptr<SliceStack>> stacks_;  // those that have not ended
  ContourGatherer together_;
  std::int64_t top_ = 0;
  core::LayerIndex index_ = 0;
  bool told_ = false;
};

}  // namespace

Result<std::unique_ptr<LayerReader>> open_threemf_slices(ZipArchive archive,
                                                         std::vector<SlicedItem> items) {
  RIND_CHECK(!items.empty() && items.size() <= kSlicedItemsMax);
  auto reader = std::make_unique<SlicesReader>(std::move(archive));
  if (Status opened = reader->open(std::move(items)); !opened.ok()) return opened.error();
  return std::unique_ptr<LayerReader>(std::move(reader));
}

}  // namespace host
