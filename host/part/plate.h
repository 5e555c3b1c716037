// Several parts, copies of them, or the two pieces of a part that is cut, on one bed, printed layer
// by layer together.
//
//     a.stl ──> its slices ─┬─ moved ──┐
//                           └─ moved ──┤ copies          each slice is read once, and moved to
//     b.stl ──> its slices ─── moved ──┴──> one slice    the place of each copy
//
// Boxes of objects don't meet (arrangement.h), so a slice of all of them is the rings of each, one
// after another, and which object a point belongs to is told by the boxes alone.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/result.h"            // Result
#include "core/settings.h"          // Settings
#include "core/units.h"             // LayerIndex
#include "host/part/bed_placing.h"  // Shift
#include "host/part/opened_part.h"  // OpenedPart, OpenOptions

namespace host {

// Whether the parts are several objects: more than one file, copies or pieces of one.
[[nodiscard]] bool is_plate(const std::vector<std::string>& paths, const core::Settings& settings);

// Opens each part as open_part() does, in a share of the sort's memory, and arranges them. Where
// each lies is known when all of them have been read to their end.
// Errors: those of open_part(), of a part that does not fit, and of arranged(); more than
// kObjectsMax objects; one whose size is not known before it is printed; a spiral vase. When slices
// are read: layers of different heights.
// COSTS: memory of each file's slices, not of its copies'. REQUIRES: one path or more.
[[nodiscard]] core::Result<OpenedPart> open_plate(const std::vector<std::string>& paths,
                                                  const core::Settings& settings,
                                                  const OpenOptions& options);

// One of the objects, and how to read it alone.
struct PlateObject {
  std::string path;
  core::Settings settings;  // that it is opened with
  Shift shift;              // from where it is opened to where it lies
  PartObject object;
  core::LayerIndex layers = 0;  // its raft's counted
};

struct PlateSurvey {
  PartSummary summary;
  std::vector<PlateObject> objects;  // as in the summary
};

// Where open_plate() lays them, but each item of a part (part_items.h) by itself. Reads each part
// to its end, again for each of its items, and holds none of it. Errors: as there.
[[nodiscard]] core::Result<PlateSurvey> survey_plate(const std::vector<std::string>& paths,
                                                     const core::Settings& settings,
                                                     const OpenOptions& options);

// The object alone, where it lies. It is read again. Errors: those of open_part().
[[nodiscard]] core::Result<OpenedPart> open_object(const PlateObject& object,
                                                   const OpenOptions& options);

}  // namespace host
