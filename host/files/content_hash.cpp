#include "host/files/content_hash.h"

#include <utility>

#include "host/files/input_file.h"

namespace host {

core::Result<FileContent> content_of(const std::string& path) {
  core::Result<InputFile> opened = InputFile::open(path);
  if (!opened.ok()) return opened.error();
  InputFile& file = opened.value();
  FileContent content;
  while (true) {
    const core::Result<std::string_view> window = file.window(1);
    if (!window.ok()) return window.error();
    if (window.value().empty()) return content;
    content.hash = hash_of(window.value(), content.hash);
    content.bytes += static_cast<std::int64_t>(window.value().size());
    file.skip(window.value().size());
  }
}

core::Result<FileContent> contents_of(const std::vector<std::string>& paths) {
  FileContent all;
  for (const std::string& path : paths) {
    const core::Result<FileContent> one = content_of(path);
    if (!one.ok() || paths.size() == 1) return one;
    all.bytes += one.value().bytes;
    for (int shift = 0; shift < 64; shift += 8) {
      const auto byte = static_cast<char>(one.value().hash >> shift & 0xff);
      all.hash = hash_of(std::string_view(&byte, 1), all.hash);
    }
  }
  return all;
}

}  // namespace host
