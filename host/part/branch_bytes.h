// A layer's branches as bytes of a temporary file (record_spool.h).
#pragma once

#include <string>
#include <string_view>

#include "core/walls/branch.h"  // Branches

namespace host {

[[nodiscard]] std::string branch_bytes(const core::Branches& branches);

// REQUIRES: bytes that branch_bytes() made.
[[nodiscard]] core::Branches branches_in(std::string_view bytes);

}  // namespace host
