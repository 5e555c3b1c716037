#include "host/commands/thumbnails.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "core/result.h"                 // Result
#include "host/output/thumbnail_text.h"  // append_thumbnails, read_thumbnails
#include "host/part/cut_plane.h"         // is_cut

namespace host {
namespace {

// Why no picture shows the whole part.
std::string_view cause_of(const PartSummary& summary, bool cut, bool drawn) {
  if (cut) return "the part is cut in two";
  if (summary.facets == 0) return "the part comes as slices, which have no surface to draw";
  if (summary.layers == 0) return "the part is sliced as it arrives";
  if (!drawn) return "--memory-limit leaves no memory for it";
  return "the part is composed of several meshes";
}

}  // namespace

void draw_objects(PrintPlan& print_plan, std::optional<PartView>& view) {
  OpenedPart& part = print_plan.part;
  const bool wanted = !print_plan.settings.thumbnails.empty();
  if (!wanted || part.summary.seen_whole || !part.draw || part.summary.objects.empty()) return;
  view.emplace();
  // What can't be read again is told when it is sliced.
  part.summary.seen_whole =
      part.draw([&view](const core::Triangle& facet) { view->add(facet); }).ok();
}

std::string thumbnail_comments(const PrintPlan& print_plan, const std::optional<PartView>& view,
                               Reporter& reporter) {
  const PrintSettings& settings = print_plan.settings;
  const core::Result<std::vector<Thumbnail>> thumbnails =
      read_thumbnails(settings.thumbnails, settings.thumbnails_format);
  // validate_settings() has told what is wrong with it.
  if (!thumbnails.ok() || thumbnails.value().empty()) return {};
  std::string comments;
  if (print_plan.part.summary.seen_whole && view && !view->empty()) {
    append_thumbnails(*view, thumbnails.value(), comments);
    return comments;
  }
  const std::string none = fmt::format(
      "no thumbnail: {}", cause_of(print_plan.part.summary, is_cut(settings), view.has_value()));
  reporter.note("thumbnail", none);
  return fmt::format("; {}\n", none);
}

}  // namespace host
