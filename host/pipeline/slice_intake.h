// Takes the part's slices one after another, as they are to be built: checked, bad ones treated as
// the user wants, contours compensated.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/result.h"                 // Result
#include "core/settings.h"               // Settings
#include "core/slices/slice.h"           // Slice
#include "core/supports/support_fold.h"  // SupportLayer
#include "core/units.h"                  // LayerIndex
#include "host/part/bad_layers.h"        // BadLayers, OnBadLayer
#include "host/part/opened_part.h"       // OpenedPart
#include "host/system/warning_box.h"     // WarningBox

namespace host {

struct TakenSlice {
  std::optional<core::Slice> slice;           // nullopt: the part has ended
  std::optional<std::string> pause;           // why to pause before its layer
  std::optional<core::SupportLayer> support;  // if they are known as soon (support_ahead.h)
};

class SliceIntake {
 public:
  // `name`: of the part, for messages. All but the action outlive the intake.
  SliceIntake(OpenedPart& part, const std::string& name, const core::Settings& settings,
              OnBadLayer action, WarningBox& warnings)
      : part_(part), name_(name), settings_(settings), bad_layers_(action, name, warnings) {}

  // The next slice up. Errors: of the source; a layer too high or too low for the settings; a bad
  // layer that ends the print. REQUIRES: the part has been read (OpenedPart::read_rest).
  [[nodiscard]] core::Result<TakenSlice> next();

  // Of the part, without its raft; 0 if not known.
  [[nodiscard]] core::LayerIndex layers() const;
  [[nodiscard]] core::LayerIndex taken() const { return taken_; }
  [[nodiscard]] std::int64_t bad_layers() const { return bad_layers_.count(); }

 private:
  OpenedPart& part_;
  const std::string& name_;
  const core::Settings& settings_;
  BadLayers bad_layers_;
  core::LayerIndex taken_ = 0;
};

}  // namespace host
