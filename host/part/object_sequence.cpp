#include "host/part/object_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "host/part/part_items.h"  // object_name

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;

// The last one is the highest: only it may be higher than the gantry.
Status check_heights(const std::vector<PlateObject>& objects, const core::Settings& settings) {
  if (objects.size() < 2) return {};
  const PartObject& before_last = objects[objects.size() - 2].object;
  if (before_last.height <= settings.clearance_height) return {};
  return Error{ErrorCode::kOutOfBounds,
               fmt::format("{} is {:g} mm high, {} {:g} mm: the printer's gantry, which is "
                           "clearance_height = {:g} mm above the nozzle, would hit the first of "
                           "them when the other one is begun; print them together, without "
                           "sequential",
                           before_last.name, before_last.height.mm(), objects.back().object.name,
                           objects.back().object.height.mm(), settings.clearance_height.mm())};
}

// Puts the objects in order, and names them in that order.
Result<PartSummary> in_order(PlateSurvey survey, const core::Settings& settings,
                             ObjectSequence& sequence) {
  std::vector<PlateObject>& objects = survey.objects;
  std::stable_sort(objects.begin(), objects.end(), [](const PlateObject& a, const PlateObject& b) {
    return a.object.height < b.object.height;
  });
  PartSummary& summary = survey.summary;
  summary.objects.clear();
  summary.layers = 0;
  for (PlateObject& each : objects) {
    each.object.name = object_name(each.object.title, summary.objects.size() + 1);
    summary.objects.push_back(each.object);
    summary.layers += each.layers;
  }
  if (Status clear = check_heights(objects, settings); !clear.ok()) return clear.error();
  sequence.set_objects(std::move(objects));
  return std::move(summary);
}

}  // namespace

core::LayerIndex ObjectSequence::layers_before(std::size_t object) const {
  core::LayerIndex before = 0;
  for (std::size_t i = 0; i < object; ++i) before += objects_[i].layers;
  return before;
}

std::size_t ObjectSequence::of_layer(core::LayerIndex layer) const {
  std::size_t object = 0;
  while (object + 1 < objects_.size() && layers_before(object + 1) <= layer) ++object;
  return object;
}

Result<OpenedPart> ObjectSequence::open(std::size_t object) const {
  return open_object(objects_[object], options_);
}

Result<OpenedPart> open_sequence(const std::vector<std::string>& paths,
                                 const core::Settings& settings, const OpenOptions& options) {
  if (std::find(paths.begin(), paths.end(), "-") != paths.end()) {
    return Error{ErrorCode::kBadSetting,
                 "sequential: standard input can be read once only, and each object is read twice; "
                 "print the part from a file"};
  }
  if (!settings.at_height.empty()) {
    return Error{ErrorCode::kBadSetting,
                 "at_height: with sequential, a height is reached once for each object; print the "
                 "objects together, or one at a time"};
  }
  OpenedPart part;
  part.sequence = std::make_shared<ObjectSequence>(options);
  part.draw = [sequence = part.sequence](const FacetObserver& on_facet) -> Status {
    for (std::size_t i = 0; i < sequence->size(); ++i) {
      const Result<OpenedPart> object = sequence->open(i);
      if (!object.ok()) return object.error();
      if (!object.value().draw) {
        return Error{ErrorCode::kBadPart, sequence->path(i) + ": no mesh that can be drawn"};
      }
      if (Status drawn = object.value().draw(on_facet); !drawn.ok()) return drawn;
    }
    return {};
  };
  part.read_rest = [paths, settings, options, sequence = part.sequence]() -> Result<PartSummary> {
    Result<PlateSurvey> survey = survey_plate(paths, settings, options);
    if (!survey.ok()) return survey.error();
    return in_order(std::move(survey).value(), settings, *sequence);
  };
  return part;
}

}  // namespace host
