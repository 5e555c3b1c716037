#include "host/output/picture_file.h"

#include <utility>

namespace host {

PictureFile::PictureFile(OutputFile file, PictureFormat format) : file_(std::move(file)) {
  if (format == PictureFormat::kPng) painter_.emplace();
}

core::Status PictureFile::write(const std::string& svg) {
  if (!painter_) return file_.write(svg);
  painter_->paint(svg);
  return {};
}

core::Status PictureFile::commit() {
  if (painter_) {
    if (core::Status written = file_.write(painter_->png()); !written.ok()) return written;
  }
  return file_.commit();
}

}  // namespace host
