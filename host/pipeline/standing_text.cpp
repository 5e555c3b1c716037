#include "host/pipeline/standing_text.h"

#include <fmt/format.h>

#include <optional>

namespace host {
namespace {

std::string place(core::Point at) {
  return fmt::format("({:.1f}, {:.1f}) mm on the bed", core::Length::from_units(at.x).mm(),
                     core::Length::from_units(at.y).mm());
}

std::string loose_text(const core::StandingReport& report) {
  const core::StandingBody& body = *report.loosest;
  std::string text = fmt::format("it stands {:g} mm high on a foot {:.1f} mm broad at {}",
                                 body.height.mm(), body.foot.breadth_mm, place(body.foot.at));
  if (report.loose_bodies > 1) {
    text += fmt::format(", and alike on {} more", report.loose_bodies - 1);
  }
  const std::optional<int> brim_mm = core::brim_that_holds_mm(body.foot, body.height.mm());
  if (!brim_mm) return text + ": it may come loose, and a brim is not enough to hold it";
  return text + fmt::format(": it may come loose; set brim_width={}", *brim_mm);
}

std::string column_text(const core::StandingReport& report) {
  const core::ThinColumn& column = *report.thinnest;
  std::string text =
      fmt::format("a column at {} is at most {:.1f} mm thick from {:g} to {:g} mm of height",
                  place(column.at), column.thickness_mm, column.bottom.mm(), column.top.mm());
  if (report.thin_columns > 1) {
    text += fmt::format(", and there are {} more", report.thin_columns - 1);
  }
  return text +
         ": it may bend under the nozzle; print slower there (height_slowdown_from), or make it "
         "thicker";
}

}  // namespace

std::vector<std::string> standing_text(const core::StandingReport& report) {
  std::vector<std::string> lines;
  if (report.loosest) lines.push_back(loose_text(report));
  if (report.thinnest) lines.push_back(column_text(report));
  return lines;
}

}  // namespace host
