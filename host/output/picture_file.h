// A picture as it is drawn: SVG goes into its file at once, for PNG it is painted.
#pragma once

#include <optional>
#include <string>

#include "core/result.h"                // Status
#include "host/files/output_file.h"     // OutputFile
#include "host/output/output_format.h"  // PictureFormat
#include "host/output/svg_painter.h"    // SvgPainter

namespace host {

class PictureFile {
 public:
  PictureFile(OutputFile file, PictureFormat format);

  // The next piece of the drawing, whole tags.
  [[nodiscard]] core::Status write(const std::string& svg);
  // The picture is complete.
  [[nodiscard]] core::Status commit();

 private:
  OutputFile file_;
  std::optional<SvgPainter> painter_;  // of a PNG
};

}  // namespace host
