#include "host/formats/zip_archive.h"

#include <fcntl.h>
#include <unistd.h>
#include <zip.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <utility>

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

Error unreadable(const std::string& name, const std::string& cause) {
  return {ErrorCode::kUnreadable, name + ": " + cause};
}

Error bad_zip(const std::string& name, const std::string& cause) {
  return {ErrorCode::kBadPart, name + ": " + cause};
}

// A file without a name that holds all of `file`.
Result<int> copied(InputFile& file) {
  const char* named = std::getenv("TMPDIR");
  std::string path =
      std::string(named != nullptr && *named != '\0' ? named : "/tmp") + "/rind_XXXXXX";
  const int descriptor = ::mkostemp(path.data(), O_CLOEXEC);
  if (descriptor < 0) {
    return unreadable(path, std::string("a temporary file can't be made: ") + std::strerror(errno) +
                                "; set TMPDIR to another folder");
  }
  ::unlink(path.c_str());
  while (true) {
    const Result<std::string_view> window = file.window(1);
    if (!window.ok() || window.value().empty()) {
      if (window.ok()) return descriptor;
      ::close(descriptor);
      return window.error();
    }
    const ssize_t count = ::write(descriptor, window.value().data(), window.value().size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const int cause = errno;
      ::close(descriptor);
      return unreadable(path, std::string("a temporary file can't be written: ") +
                                  std::strerror(cause) + "; make room, or set TMPDIR");
    }
    file.skip(static_cast<std::size_t>(count));
  }
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return text;
}

}  // namespace

struct ZipArchive::State {
  std::string name;
  zip_t* archive = nullptr;

  ~State() {
    if (archive != nullptr) zip_discard(archive);
  }

  [[nodiscard]] std::optional<zip_uint64_t> place_of(const std::string& entry) const {
    const zip_int64_t at = zip_name_locate(archive, entry.c_str(), ZIP_FL_NOCASE);
    return at < 0 ? std::nullopt : std::optional(static_cast<zip_uint64_t>(at));
  }
};

ZipArchive::ZipArchive(std::shared_ptr<State> state) : state_(std::move(state)) {}
ZipArchive::~ZipArchive() = default;
ZipArchive::ZipArchive(ZipArchive&&) noexcept = default;
const std::string& ZipArchive::name() const { return state_->name; }

Result<ZipArchive> ZipArchive::open(InputFile file) {
  const std::string name = file.name();
  Result<int> descriptor =
      file.rereadable() ? Result<int>(::open(name.c_str(), O_RDONLY | O_CLOEXEC)) : copied(file);
  if (!descriptor.ok()) return descriptor.error();
  if (descriptor.value() < 0) return unreadable(name, std::strerror(errno));
  auto state = std::make_shared<State>();
  state->name = name;
  int code = 0;
  state->archive = zip_fdopen(descriptor.value(), 0, &code);
  if (state->archive == nullptr) {
    ::close(descriptor.value());
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    const std::string cause = zip_error_strerror(&error);
    zip_error_fini(&error);
    return bad_zip(name, "the zip archive can't be read: " + cause +
                             "; it is damaged or cut short, copy or export it again");
  }
  const zip_int64_t entries = zip_get_num_entries(state->archive, 0);
  if (entries > kZipEntriesMax) {
    return bad_zip(name, "the zip archive has " + std::to_string(entries) + " entries, more than " +
                             std::to_string(kZipEntriesMax) + "; this is no part");
  }
  return ZipArchive(std::move(state));
}

bool ZipArchive::contains(const std::string& entry) const {
  return state_->place_of(entry).has_value();
}

std::string ZipArchive::find_ending(const std::string& ending) const {
  const zip_int64_t entries = zip_get_num_entries(state_->archive, 0);
  for (zip_int64_t i = 0; i < entries; ++i) {
    const char* entry = zip_get_name(state_->archive, static_cast<zip_uint64_t>(i), 0);
    if (entry != nullptr && lower(entry).ends_with(ending)) return entry;
  }
  return {};
}

Result<XmlScanner::ByteSource> ZipArchive::bytes_of(const std::string& entry) const {
  const std::string name = state_->name + " (" + entry + ")";
  const std::optional<zip_uint64_t> at = state_->place_of(entry);
  if (!at) return bad_zip(name, "there is no such entry in the zip archive; export it again");
  zip_stat_t status;
  zip_stat_init(&status);
  const bool known = zip_stat_index(state_->archive, *at, 0, &status) == 0 &&
                     (status.valid & ZIP_STAT_SIZE) != 0 &&
                     (status.valid & ZIP_STAT_COMP_SIZE) != 0;
  if (!known) return bad_zip(name, "its size is not known; export it again");
  if (status.size > kZipBombBytes && status.size / kZipBombRatio > status.comp_size) {
    return bad_zip(name, std::to_string(status.comp_size) + " bytes that unpack to " +
                             std::to_string(status.size) +
                             ": refused as a zip bomb; export the part again");
  }
  zip_file_t* opened = zip_fopen_index(state_->archive, *at, 0);
  if (opened == nullptr) {
    return bad_zip(name, std::string("can't be unpacked: ") + zip_strerror(state_->archive) +
                             "; export it again");
  }
  std::shared_ptr<zip_file_t> file(opened, [](zip_file_t* f) { zip_fclose(f); });
  // The list may lie about the size.
  auto left = std::make_shared<std::uint64_t>(status.size);
  return XmlScanner::ByteSource(
      [state = state_, file, left, name](char* into, std::size_t size) -> Result<std::size_t> {
        const zip_int64_t count = zip_fread(file.get(), into, size);
        if (count < 0) {
          return bad_zip(name, std::string("can't be unpacked: ") +
                                   zip_error_strerror(zip_file_get_error(file.get())) +
                                   "; the file is damaged, copy or export it again");
        }
        if (static_cast<std::uint64_t>(count) > *left) {
          return bad_zip(name, "unpacks to more than its size says; the file is damaged");
        }
        *left -= static_cast<std::uint64_t>(count);
        return static_cast<std::size_t>(count);
      });
}

}  // namespace host
