// The head of a Common Layer Interface file (CLI 2.0). The head is always text.
//
//     $$HEADERSTART … $$HEADEREND; text before it is ignored, so are other $$ words
//     $$ASCII or $$BINARY   $$UNITS/mm for each coordinate unit      (both are needed)
//     $$VERSION/200   $$LAYERS/n   $$ALIGN   $$DIMENSION/x1,y1,z1,x2,y2,z2 in mm   $$LABEL/id,text
//     $$USERDATA/uid,n,… followed by n raw bytes   // comments //
#pragma once

#include <array>
#include <optional>

#include "core/result.h"                // Result
#include "core/units.h"                 // LayerIndex
#include "host/formats/text_scanner.h"  // TextScanner

namespace host {

struct CliHeader {
  bool binary = false;
  bool aligned = false;  // binary: every item starts on a 32-bit boundary
  double unit_mm = 0;
  core::LayerIndex layers = 0;  // 0: not given
  std::optional<std::array<double, 6>> dimension_mm;
};

// Leaves the scanner right behind $$HEADEREND.
[[nodiscard]] core::Result<CliHeader> read_cli_header(TextScanner& text);

}  // namespace host
