// The text of a binary G-code file: what its G-code blocks hold, one behind the other.
//
//     block ──unpack──> bytes ──MeatPack, where its encoding says so──> text
//
// Memory: one block, packed and unpacked (kBlockBytesMax).
#pragma once

#include <memory>

#include "host/gcode/file_bytes.h"  // FileBytes
#include "host/gcode/gcode_text.h"  // GcodeText

namespace host {

// REQUIRES: the bytes outlive the text.
[[nodiscard]] std::unique_ptr<GcodeText> bgcode_text(const FileBytes& bytes);

}  // namespace host
