#include "host/part/mesh_summary.h"

#include <optional>

namespace host {

void summarise_file(const TriangleSource& file, const MeshSurvey& survey, const std::string& name,
                    PartSummary& summary) {
  summary.format = file.format();
  summary.facets = file.facets();
  summary.degenerate = survey.degenerate();
  summary.warnings = file.warnings();
  if (const std::string& doubt = file.doubt(); !doubt.empty()) {
    summary.warnings.push_back(name + ": " + doubt +
                               "; the surface is closed, so all that are there were taken");
  }
  if (const auto warning = unit_warning(survey.extent())) {
    summary.warnings.push_back(name + ": " + *warning);
  }
}

void warn_of_empty_layers(MeshSurvey& survey, const core::LayerHeights& heights,
                          const std::string& name, PartSummary& summary) {
  const MeshSurvey::EmptyLayers empty = survey.empty_layers(heights);
  if (empty.count == 0) return;
  summary.warnings.push_back(name + ": " + std::to_string(empty.count) +
                             " layers hold nothing, from layer " + std::to_string(empty.first + 1) +
                             " on: what is above them is printed in the air");
}

}  // namespace host
