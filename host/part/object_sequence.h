// Several objects that are printed one after another (`sequential`), the lowest first.
//
//              │ gantry           A print head reaches clearance_radius around the nozzle, so
//      ────────┴────────          objects lie at least so far apart (arrangement.h). The gantry
//          ┌─┐ clearance_height   is clearance_height above the nozzle's tip, which begins each
//     ▐▌   └┬┘                    object at the bed, so what is finished must be lower than that.
//     ▐▌    ▽ ▂▂
//
// Each file is read twice, or once more for each copy, and none of it is held: memory is that of
// the object at hand. The items of a 3MF are objects, too: it is read twice for each of them.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"            // Result
#include "core/settings.h"          // Settings
#include "core/units.h"             // LayerIndex
#include "host/part/opened_part.h"  // OpenedPart, OpenOptions
#include "host/part/plate.h"        // PlateObject

namespace host {

class ObjectSequence {
 public:
  explicit ObjectSequence(const OpenOptions& options) : options_(options) {}

  // In the order in which they are printed. REQUIRES: the part was read (OpenedPart::read_rest), as
  // for all that follows.
  void set_objects(std::vector<PlateObject> objects) { objects_ = std::move(objects); }

  [[nodiscard]] std::size_t size() const { return objects_.size(); }
  [[nodiscard]] const std::string& path(std::size_t object) const { return objects_[object].path; }
  // Layers of the print that come before its own.
  [[nodiscard]] core::LayerIndex layers_before(std::size_t object) const;
  // The object that this layer of the print is of; the last one for those behind it.
  [[nodiscard]] std::size_t of_layer(core::LayerIndex layer) const;

  // Errors: those of open_part().
  [[nodiscard]] core::Result<OpenedPart> open(std::size_t object) const;

 private:
  OpenOptions options_;
  std::vector<PlateObject> objects_;
};

// As open_plate(), with OpenedPart::sequence instead of layers. Its summary's objects are in the
// order in which they are printed, and `layers` are those of all of them. Errors, besides: two
// objects are higher than clearance_height; a part from standard input, which can't be read again;
// at_height, because a height comes more than once.
// REQUIRES: is_plate(), or a part of several items.
[[nodiscard]] core::Result<OpenedPart> open_sequence(const std::vector<std::string>& paths,
                                                     const core::Settings& settings,
                                                     const OpenOptions& options);

}  // namespace host
