// What people have marked in a part's file for supports: bodies within which what hangs is held or
// not, and facets that are painted so. Facets as the part's own: placed by the file, snapped, in
// any order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"             // Triangle
#include "core/result.h"               // Result, Status
#include "host/files/record_spool.h"   // RecordSpool
#include "host/formats/mesh_extent.h"  // MeshExtent

namespace host {

enum class SupportMark : std::uint8_t { kEnforcer, kBlocker };

struct MarkCounts {
  std::int64_t enforcers = 0;  // bodies
  std::int64_t blockers = 0;
  std::int64_t painted = 0;  // facets

  [[nodiscard]] bool any() const { return enforcers + blockers + painted > 0; }
  // "2 support enforcers, 1 support blocker, 40 facets painted for supports"
  [[nodiscard]] std::string text() const;
};

// Facets in a temporary file without a name, which is made with the first one: written in one go,
// then read in one go.
class FacetSpool {
 public:
  // Errors: as SpillFile. REQUIRES: nothing was read so far.
  [[nodiscard]] core::Status add(const core::Triangle& facet);
  // The next one, in the order in which they were added; nullopt at the end.
  [[nodiscard]] core::Result<std::optional<core::Triangle>> next();

  // Whether none was ever added.
  [[nodiscard]] bool empty() const { return !spool_; }
  // Of all that were added.
  [[nodiscard]] const MeshExtent& extent() const { return extent_; }

 private:
  std::optional<RecordSpool> spool_;
  MeshExtent extent_;
};

class MarkedFacets {
 public:
  // Of closed bodies.
  [[nodiscard]] FacetSpool& bodies(SupportMark mark) { return bodies_[index(mark)]; }
  // Painted ones, or pieces of them.
  [[nodiscard]] FacetSpool& painted(SupportMark mark) { return painted_[index(mark)]; }

  // Whether anything is enforced.
  [[nodiscard]] bool enforces() const {
    return !bodies_[index(SupportMark::kEnforcer)].empty() ||
           !painted_[index(SupportMark::kEnforcer)].empty();
  }
  // Of the bodies.
  [[nodiscard]] MeshExtent bodies_extent() const;

  // Of what is printed of the plate, as the file places it; empty if it is not known, or if there
  // are no bodies, beside which alone it matters.
  MeshExtent printed;

  // Painting that could not be read; its facets are taken as not painted. To follow the file's
  // name.
  std::vector<std::string> warnings;

 private:
  static std::size_t index(SupportMark mark) { return static_cast<std::size_t>(mark); }

  std::array<FacetSpool, 2> bodies_, painted_;
};

}  // namespace host
