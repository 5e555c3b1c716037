// Plug point: a source of a mesh's triangles, in any order, read on demand. One for each mesh
// format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"               // Triangle
#include "core/result.h"                 // Result, Status
#include "host/formats/modifier_body.h"  // ModifierBody
#include "host/formats/support_marks.h"  // MarkCounts, MarkedFacets

namespace host {

class TriangleSource {
 public:
  virtual ~TriangleSource() = default;

  // For people: "binary STL".
  [[nodiscard]] virtual std::string format() const = 0;

  // The next triangle, snapped to the grid, x and y within ±kCoordinateMax; nullopt at the end.
  // Errors name the file and the position in it, and are final.
  [[nodiscard]] virtual core::Result<std::optional<core::Triangle>> next() = 0;

  // Appends the next ones, at most `most`; fewer only at the end. Errors: as next(); those before
  // the error are appended.
  [[nodiscard]] virtual core::Status next_some(std::size_t most,
                                               std::vector<core::Triangle>& into) {
    for (; most > 0; --most) {
      core::Result<std::optional<core::Triangle>> triangle = next();
      if (!triangle.ok()) return triangle.error();
      if (!triangle.value()) break;
      into.push_back(*triangle.value());
    }
    return {};
  }

  // Starts again at the first triangle, where the file need not be read again for that. False: it
  // must be, and nothing has changed. REQUIRES: no next() has failed
  [[nodiscard]] virtual core::Result<bool> rewind() { return false; }

  // From now on a number of the file is so many mm. False: the file tells its own unit, and nothing
  // has changed. REQUIRES: before the first next()
  [[nodiscard]] virtual bool read_in(double /*unit_mm*/) { return false; }

  // What is marked in the file for supports.
  [[nodiscard]] virtual MarkCounts mark_counts() const { return {}; }
  // The same; nullptr if nothing is marked. Errors: as next(). REQUIRES: before the first next().
  [[nodiscard]] virtual core::Result<std::unique_ptr<MarkedFacets>> marked_facets() {
    return std::unique_ptr<MarkedFacets>();
  }

  // Bodies within which the file asks for other settings. Errors: as next(). REQUIRES: before the
  // first next().
  [[nodiscard]] virtual core::Result<std::vector<ModifierBody>> modifiers() {
    return std::vector<ModifierBody>();
  }

  // Names of the things that the file lays onto the bed, and that may be objects of their own; a
  // name may be empty. None: it is one thing.
  [[nodiscard]] virtual std::vector<std::string> items() const { return {}; }
  // The thing that the last triangle is of, by its number. REQUIRES: items() has some.
  [[nodiscard]] virtual std::size_t item() const { return 0; }
  // Leaves out all others. REQUIRES: items() has these numbers; before the first next().
  [[nodiscard]] virtual core::Status keep_items(const std::vector<std::size_t>& /*items*/) {
    return {};
  }

  // Triangles given so far.
  [[nodiscard]] std::int64_t facets() const { return facets_; }
  // What was odd and how it was treated: a few at most. Complete once next() has returned nullopt.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  // Why the file may have been cut off between two triangles, without its name; empty if it is
  // complete. Known at the end, too. The caller decides by the surface: that of a cut file is open.
  [[nodiscard]] const std::string& doubt() const { return doubt_; }

 protected:
  std::int64_t facets_ = 0;
  std::vector<std::string> warnings_;
  std::string doubt_;
};

}  // namespace host
