// Checks that a mesh's height is plausible: a single stray corner makes a part of hundreds of
// millions of layers. An implausible mesh is refused unless --tall says that it is meant.
//
//     a stray corner    at most kStrayCornersMax corners reach farther than all others, by at least
//                       kStrayAlone_mm and kStrayTimes the longest side of the rest
//     a gap             kAirGap_mm of height without any facet
//     few facets        more than kLayersUnasked layers, and a tenth of the height without a corner
//
// A tower whose facets fill its height passes, however many layers it has.
#pragma once

#include <string>

#include "core/result.h"            // Status
#include "core/settings.h"          // Settings
#include "core/units.h"             // LayerIndex
#include "host/part/mesh_survey.h"  // MeshSurvey

namespace host {

inline constexpr double kStrayAlone_mm = 200;
inline constexpr int kStrayTimes = 20;
inline constexpr double kAirGap_mm = 100;
inline constexpr core::LayerIndex kLayersUnasked = 100'000;
inline constexpr int kEmptyShare = 10;  // a tenth

// For a mesh that was read to its end. kOutOfBounds says what looks wrong, which facet and where,
// how high the rest is, and what to do; it starts with `name`. REQUIRES: survey.highest_cut()
[[nodiscard]] core::Status check_height(MeshSurvey& survey, const core::LayerHeights& heights,
                                        const std::string& name);

// For a mesh that is still being read: an error if a single facet spans kLayersUnasked layers.
[[nodiscard]] core::Status check_height_so_far(const MeshSurvey& survey,
                                               const core::LayerHeights& heights,
                                               const std::string& name);

// Why a mesh is too large, if few corners make it so: "; facet 13 has a corner at …, without it the
// part is 20 mm wide". Empty otherwise.
[[nodiscard]] std::string stray_text(const MeshSurvey& survey);

}  // namespace host
