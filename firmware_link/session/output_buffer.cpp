#include "firmware_link/session/output_buffer.h"

#include <cstring>

#include "firmware_link/wire/check.h"

namespace firmware_link {

void OutputBuffer::put(std::string_view bytes) {
  LINK_CHECK(has_room_for(bytes.size()));
  if (end_ + bytes.size() > bytes_.size()) {
    std::memmove(bytes_.data(), bytes_.data() + start_, end_ - start_);
    end_ -= start_;
    start_ = 0;
  }
  std::memcpy(bytes_.data() + end_, bytes.data(), bytes.size());
  end_ += bytes.size();
}

void OutputBuffer::written(std::size_t count) {
  LINK_CHECK(count <= end_ - start_);
  start_ += count;
  if (empty()) clear();
}

}  // namespace firmware_link
