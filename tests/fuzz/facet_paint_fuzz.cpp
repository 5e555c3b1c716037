// What is painted on a facet: any text is a whole tree or none, and no piece leaves the facet.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/check.h"
#include "host/formats/facet_paint.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (!host::is_paint(text)) return 0;
  const core::Triangle facet{{{{0, 0, 0}, {160'001, 3, 70'000}, {-5, 90'007, 20'000}}}};
  std::size_t pieces = 0;
  const core::Status done = host::each_painted_piece(
      text, facet, [&](const core::Triangle& piece, host::FacetPaint paint) -> core::Status {
        RIND_CHECK(paint != host::FacetPaint::kNone);
        for (const core::Vertex& corner : piece.corners) {
          RIND_CHECK(corner.x >= -5 && corner.x <= 160'001 && corner.y >= 0 && corner.y <= 90'007 &&
                     corner.z >= 0 && corner.z <= 70'000);
        }
        ++pieces;
        return {};
      });
  RIND_CHECK(done.ok() && pieces <= size);
  return 0;
}
