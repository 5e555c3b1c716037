#include "host/files/record_spool.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

#include "core/check.h"          // RIND_CHECK
#include "host/system/limits.h"  // kSpoolBufferBytes

namespace host {
namespace {

using Length = std::uint32_t;
constexpr std::size_t kLengthBytes = sizeof(Length);

void put_length(std::size_t length, std::string& into) {
  RIND_CHECK(length <= std::numeric_limits<Length>::max());
  const auto value = static_cast<Length>(length);
  char bytes[kLengthBytes];
  std::memcpy(bytes, &value, kLengthBytes);
  into.append(bytes, kLengthBytes);
}

std::size_t length_in(std::string_view bytes) {
  Length value = 0;
  std::memcpy(&value, bytes.data(), kLengthBytes);
  return value;
}

}  // namespace

core::Result<RecordSpool> RecordSpool::create(const std::string& folder, SpillUse use) {
  core::Result<SpillFile> file = SpillFile::create(folder, use);
  if (!file.ok()) return file.error();
  return RecordSpool(std::move(file).value());
}

core::Status RecordSpool::append(std::string_view bytes) {
  put_length(bytes.size(), unwritten_);
  unwritten_.append(bytes);
  put_length(bytes.size(), unwritten_);
  return unwritten_.size() < kSpoolBufferBytes ? core::Status() : write_out();
}

core::Status RecordSpool::write_out() {
  if (unwritten_.empty()) return {};
  core::Status written = file_.append(unwritten_);
  unwritten_.clear();
  return written;
}

void RecordSpool::go_to_end() { here_ = next_place(); }

void RecordSpool::go_to_start() { here_ = 0; }

core::Result<std::string_view> RecordSpool::look(std::int64_t from, std::size_t size, bool down) {
  if (core::Status written = write_out(); !written.ok()) return written.error();
  const std::int64_t to = from + static_cast<std::int64_t>(size);
  const auto buffered = static_cast<std::int64_t>(buffer_.size());
  if (from < buffer_from_ || to > buffer_from_ + buffered) {
    const auto room = static_cast<std::int64_t>(std::max(size, kSpoolBufferBytes));
    buffer_from_ = down ? std::max(to - room, std::int64_t{0}) : from;
    buffer_.resize(static_cast<std::size_t>(std::min(room, file_.size() - buffer_from_)));
    core::Status read = file_.read(buffer_from_, buffer_.data(), buffer_.size());
    if (!read.ok()) return read.error();
  }
  return std::string_view(buffer_).substr(static_cast<std::size_t>(from - buffer_from_), size);
}

core::Result<RecordSpool::Record> RecordSpool::record_at(std::int64_t place) {
  core::Result<std::string_view> head = look(place, kLengthBytes, false);
  if (!head.ok()) return head.error();
  const std::size_t length = length_in(head.value());
  core::Result<std::string_view> bytes =
      look(place + static_cast<std::int64_t>(kLengthBytes), length, false);
  if (!bytes.ok()) return bytes.error();
  return Record{place, bytes.value()};
}

core::Result<std::optional<RecordSpool::Record>> RecordSpool::next() {
  if (here_ >= next_place()) return std::optional<Record>();
  core::Result<Record> record = record_at(here_);
  if (!record.ok()) return record.error();
  here_ += static_cast<std::int64_t>(record.value().bytes.size() + 2 * kLengthBytes);
  return std::optional<Record>(record.value());
}

core::Result<std::optional<RecordSpool::Record>> RecordSpool::previous() {
  if (here_ <= 0) return std::optional<Record>();
  const auto head = static_cast<std::int64_t>(kLengthBytes);
  core::Result<std::string_view> tail = look(here_ - head, kLengthBytes, true);
  if (!tail.ok()) return tail.error();
  const std::size_t length = length_in(tail.value());
  const std::int64_t from = here_ - head - static_cast<std::int64_t>(length);
  core::Result<std::string_view> bytes = look(from, length, true);
  if (!bytes.ok()) return bytes.error();
  here_ = from - head;
  return std::optional<Record>(Record{here_, bytes.value()});
}

core::Result<RecordSpool::Record> RecordSpool::read_at(std::int64_t place) {
  return record_at(place);
}

}  // namespace host
