#include "host/formats/xml_file_bytes.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace host {

XmlScanner::ByteSource xml_bytes_of(InputFile file) {
  return [shared = std::make_shared<InputFile>(std::move(file))](
             char* into, std::size_t size) -> core::Result<std::size_t> {
    const core::Result<std::string_view> window = shared->window(1);
    if (!window.ok()) return window.error();
    const std::size_t count = std::min(size, window.value().size());
    std::copy_n(window.value().data(), count, into);
    shared->skip(count);
    return count;
  };
}

}  // namespace host
