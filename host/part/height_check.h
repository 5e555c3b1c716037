// Whether a mesh is as high as somebody can have meant it: one corner that went astray makes a part
// of hundreds of millions of layers. What looks so is asked about (--tall), not sliced.
//
//     a stray corner    the last kStrayCornersMax corners of an end reach at least kStrayAlone_mm
//                       and kStrayTimes the rest's longest side farther than all others
//     a gap             no facet at all for kAirGap_mm of height
//     few facets        more than kLayersUnasked layers, and a tenth of the height without a corner
//
// A tower whose facets fill its height is not asked about, however many layers it has.
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

// With all facets seen. kOutOfBounds: what looks wrong, the facet and its place, how high the rest
// is, and what to do; begins with `name`. REQUIRES: survey.highest_cut()
[[nodiscard]] core::Status check_height(MeshSurvey& survey, const core::Settings& settings,
                                        const std::string& name);

// With more to come, as far as a single facet tells: it alone spans kLayersUnasked layers.
[[nodiscard]] core::Status check_height_so_far(const MeshSurvey& survey,
                                               const core::Settings& settings,
                                               const std::string& name);

// Why a mesh that is too large is so, where few corners make it: "; facet 13 has a corner at …,
// without it the part is 20 mm wide". Empty: it is large by itself.
[[nodiscard]] std::string stray_text(const MeshSurvey& survey);

}  // namespace host
