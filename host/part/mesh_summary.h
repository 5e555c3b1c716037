// What a mesh's file and its survey tell of the part.
#pragma once

#include <string>

#include "host/formats/triangle_source.h"  // TriangleSource
#include "host/part/mesh_survey.h"         // MeshSurvey
#include "host/part/opened_part.h"         // PartSummary

namespace host {

// Fills in the format, the facets, and the warnings about the file. `name`: of it, for messages.
void summarise_file(const TriangleSource& file, const MeshSurvey& survey, const std::string& name,
                    PartSummary& summary);

// Adds the warning about layers that hold nothing, if there are some.
void warn_of_empty_layers(MeshSurvey& survey, const core::LayerHeights& heights,
                          const std::string& name, PartSummary& summary);

}  // namespace host
