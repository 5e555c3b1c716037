// The text of a G-code file, in pieces, from any place on.
//
//     plain    the file's own bytes
//     bgcode   what its G-code blocks hold, one behind the other (bgcode_text.h)
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/result.h"              // Result
#include "host/files/content_hash.h"  // kHashStart
#include "host/gcode/file_bytes.h"    // FileBytes

namespace host {

// Bytes of a plain file that are read at once.
inline constexpr std::size_t kTextPieceBytes = std::size_t{64} * 1'024;

// A place in the text. `block` and `within` find it in the file again.
struct TextPlace {
  std::int64_t block = 0;   // plain: where in the file; bgcode: where the block's header starts
  std::int64_t within = 0;  // plain: 0; bgcode: in the block's text
};

class GcodeText {
 public:
  virtual ~GcodeText() = default;

  // The next piece; empty at the end. Valid until the next call.
  [[nodiscard]] virtual core::Result<std::string_view> next() = 0;

  // Goes on from a place that place_in() told. REQUIRES: it is of this file, unchanged.
  [[nodiscard]] virtual core::Status go_to(const TextPlace& place) = 0;

  // The place of a byte of the piece that next() gave last.
  [[nodiscard]] virtual TextPlace place_in(std::size_t byte) const = 0;

  // What is told beside the text: bgcode's metadata, as lines "key=value".
  [[nodiscard]] virtual const std::string& metadata() const = 0;

  // How much of the file was read, of size() bytes; and the hash of all bytes. The hash is known
  // after the end, if the text was read from its start.
  [[nodiscard]] virtual std::int64_t bytes_read() const = 0;
  [[nodiscard]] virtual std::uint64_t hash() const = 0;
};

// REQUIRES: the bytes outlive the text.
[[nodiscard]] std::unique_ptr<GcodeText> plain_text(const FileBytes& bytes);

}  // namespace host
