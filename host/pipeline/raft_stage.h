// Lifts a part onto its raft (core/raft_heights.h). The pipeline computes the part as if it lay on
// the bed. What is given out counts the raft's layers, and they are laid before the part's first
// one, whose slice they cover:
//
//     the part's layer     0              1        2
//                          │
//     given out       0 … raft_layers − 1, raft_layers, …
//
// Without a raft, both are the same.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/result.h"                // Result
#include "core/roads/raft.h"            // Raft
#include "core/settings.h"              // Settings
#include "core/slices/slice.h"          // Slice
#include "core/units.h"                 // LayerIndex, Length
#include "core/walls/split_layer.h"     // SplitLayer
#include "host/pipeline/checkpoint.h"   // Checkpoint
#include "host/pipeline/layer_watch.h"  // LayerWatch

namespace host {

class RaftStage {
 public:
  // `start`: where the print is resumed, if it is. REQUIRES: the settings outlive it.
  RaftStage(const core::Settings& settings, const std::optional<Checkpoint>& start);

  [[nodiscard]] core::LayerIndex layers() const { return settings_.raft_layers; }
  // The first of them that is still to be laid; layers(): none.
  [[nodiscard]] core::LayerIndex first() const { return first_; }

  // The start in the part's own count: its layer 0 for all of the raft.
  [[nodiscard]] const std::optional<Checkpoint>& start_in_part() const { return start_in_part_; }

  // Gives the raft's layers that are still to be laid, one after another, under the part's first
  // layer and its supports. Ends when `give` returns an error. Errors of its own, in which `part`
  // is named: the first slice is empty; no road fits into the raft.
  using Give = std::function<core::Status(const core::RaftLayer&)>;
  [[nodiscard]] core::Status lay(const core::SplitLayer& first, const std::string& part,
                                 LayerWatch& watch, const Give& give) const;

  [[nodiscard]] core::Slice lifted(core::Slice slice) const;

 private:
  [[nodiscard]] core::Status check(const core::RaftLayer& layer, const std::string& part) const;
  [[nodiscard]] core::Length top(core::LayerIndex index) const;

  const core::Settings& settings_;
  const core::Length lift_;
  std::optional<Checkpoint> start_in_part_;
  core::LayerIndex first_ = 0;
};

}  // namespace host
