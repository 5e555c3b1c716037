// How the pipeline's layers are laid (core/motions/laid_layer.h), prepared in any thread before
// their turn. Layers that share their roads share this, too, where there are no supports.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/motions/laid_layer.h"      // LaidLayer
#include "core/roads/road.h"              // Road
#include "core/slices/slice.h"            // Slice
#include "core/supports/support_roads.h"  // SupportPlan
#include "host/pipeline/command_stage.h"  // CommandStage

namespace host {

class LaidRoads {
 public:
  // `supports`: null where there are none; they outlive it.
  explicit LaidRoads(const core::SupportPlan* supports) : supports_(supports) {}

  // By the thread that has put the roads in order. `slice`: CommandStage::prepared().
  void prepare(const CommandStage& commands, const core::Slice& slice,
               const std::vector<core::Road>& roads) {
    laid_ = commands.prepared(slice, with_supports(roads));
  }
  // By one thread, behind prepare(). The draft asks `slice` and `space` about travels.
  void prepare_draft(const CommandStage& commands, const core::Slice& slice,
                     const core::TravelSpace* space) {
    if (!laid_ || draft_) return;
    draft_ = commands.draft({slice.index, slice.bottom, slice.height, slice.region}, *laid_, space);
  }

  // The layer's roads with those of its supports, which are kept here.
  [[nodiscard]] const std::vector<core::Road>& with_supports(const std::vector<core::Road>& roads) {
    if (supports_ == nullptr) return roads;
    if (!all_) all_ = core::with_supports(supports_->roads, roads);
    return *all_;
  }

  // Null: it is laid in its turn.
  [[nodiscard]] const core::LaidLayer* prepared() const { return laid_ ? &*laid_ : nullptr; }
  // Null: there is none.
  [[nodiscard]] const LayerDraft* draft() const { return draft_.get(); }

 private:
  const core::SupportPlan* supports_;
  std::optional<std::vector<core::Road>> all_;
  std::optional<core::LaidLayer> laid_;
  std::shared_ptr<const LayerDraft> draft_;
};

class LaidRoadsMemory {
 public:
  using Roads = std::shared_ptr<std::vector<core::Road>>;

  // REQUIRES: `layers` > 0, as many as may lie between two that share their roads.
  explicit LaidRoadsMemory(std::size_t layers) : last_(layers) {}

  // Layers in order: what the last one with the same roads has, or a new one.
  [[nodiscard]] std::shared_ptr<LaidRoads> of(const Roads& roads,
                                              const core::SupportPlan* supports) {
    if (supports != nullptr) return std::make_shared<LaidRoads>(supports);
    for (const auto& [known, laid] : last_) {
      if (known == roads) return laid;
    }
    auto& [known, laid] = last_[next_++ % last_.size()];
    known = roads;
    laid = std::make_shared<LaidRoads>(nullptr);
    return laid;
  }

 private:
  std::vector<std::pair<Roads, std::shared_ptr<LaidRoads>>> last_;
  std::size_t next_ = 0;
};

}  // namespace host
