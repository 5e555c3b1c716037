// The pictures of the part at the head of a G-code file.
#pragma once

#include <optional>
#include <string>

#include "host/output/part_view.h"   // PartView
#include "host/pipeline/pipeline.h"  // PrintPlan
#include "host/printing/progress.h"  // Reporter

namespace host {

// Draws several objects where they lie on the bed; their files are read once more. One that was
// drawn while it was read stays as it is. REQUIRES: the part was read to its end.
void draw_objects(PrintPlan& print_plan, std::optional<PartView>& view);

// The comments, as the setting `thumbnails` says; or one that says why there are none, which is
// told to the user, too. `view`: what was drawn while the part was read; none if there
// was no memory for it.
[[nodiscard]] std::string thumbnail_comments(const PrintPlan& print_plan,
                                             const std::optional<PartView>& view,
                                             Reporter& reporter);

}  // namespace host
