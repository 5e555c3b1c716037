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

#include "host/system/text.h"  // lower_case

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

// Bytes of an entry that are unpacked at once.
constexpr std::size_t kPieceBytes = std::size_t{1} << 15;

Error unreadable(const std::string& name, const std::string& cause) {
  return {ErrorCode::kUnreadable, name + ": " + cause};
}

Error bad_zip(const std::string& name, const std::string& cause) {
  return {ErrorCode::kBadPart, name + ": " + cause};
}

// A temporary file without a name.
class UnnamedFile {
 public:
  [[nodiscard]] static Result<UnnamedFile> create() {
    const char* folder = std::getenv("TMPDIR");
    UnnamedFile file;
    file.path_ =
        std::string(folder != nullptr && *folder != '\0' ? folder : "/tmp") + "/rind_XXXXXX";
    file.descriptor_ = ::mkostemp(file.path_.data(), O_CLOEXEC);
    if (file.descriptor_ < 0) {
      return unreadable(file.path_, std::string("a temporary file can't be made: ") +
                                        std::strerror(errno) + "; set TMPDIR to another folder");
    }
    ::unlink(file.path_.c_str());
    return file;
  }
  ~UnnamedFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  UnnamedFile(UnnamedFile&& other) noexcept
      : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

  [[nodiscard]] core::Status append(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) {
        return unreadable(path_, std::string("a temporary file can't be written: ") +
                                     std::strerror(errno) + "; make room, or set TMPDIR");
      }
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return {};
  }

  // Opens it at its start; the caller closes it.
  [[nodiscard]] int release() {
    ::lseek(descriptor_, 0, SEEK_SET);
    return std::exchange(descriptor_, -1);
  }

 private:
  UnnamedFile() = default;
  std::string path_;
  int descriptor_ = -1;
};

// All of `file`, as a file with random access.
Result<int> copied(InputFile& file) {
  Result<UnnamedFile> copy = UnnamedFile::create();
  if (!copy.ok()) return copy.error();
  while (true) {
    const Result<std::string_view> window = file.window(1);
    if (!window.ok()) return window.error();
    if (window.value().empty()) return copy.value().release();
    if (core::Status added = copy.value().append(window.value()); !added.ok()) return added.error();
    file.skip(window.value().size());
  }
}

// The value of a hexadecimal digit, or -1.
int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::string entry_key(std::string_view name) {
  std::string key;
  for (std::size_t i = 0; i < name.size(); ++i) {
    char c = name[i] == '\\' ? '/' : name[i];
    if (c == '%' && i + 2 < name.size()) {
      const int high = digit_of(name[i + 1]), low = digit_of(name[i + 2]);
      if (high >= 0 && low >= 0) {
        c = static_cast<char>(high * 16 + low);
        i += 2;
      }
    }
    key += c;
  }
  while (key.starts_with('/') || key.starts_with("./")) key.erase(0, key.find('/') + 1);
  return lower_case(key);
}

struct ZipArchive::State {
  std::string name;
  zip_t* archive = nullptr;

  ~State() {
    if (archive != nullptr) zip_discard(archive);
  }

  [[nodiscard]] std::optional<zip_uint64_t> place_of(const std::string& entry) const {
    const zip_int64_t at = zip_name_locate(archive, entry.c_str(), ZIP_FL_NOCASE);
    if (at >= 0) return static_cast<zip_uint64_t>(at);
    const std::string key = entry_key(entry);
    const zip_int64_t entries = zip_get_num_entries(archive, 0);
    for (zip_int64_t i = 0; i < entries; ++i) {
      const auto index = static_cast<zip_uint64_t>(i);
      const char* named = zip_get_name(archive, index, 0);
      if (named != nullptr && entry_key(named) == key) return index;
    }
    return std::nullopt;
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
    if (entry != nullptr && lower_case(entry).ends_with(ending)) return entry;
  }
  return {};
}

std::vector<std::string> ZipArchive::entries() const {
  std::vector<std::string> names;
  const zip_int64_t count = zip_get_num_entries(state_->archive, 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* entry = zip_get_name(state_->archive, static_cast<zip_uint64_t>(i), 0);
    const std::string name = entry == nullptr ? "" : entry;
    if (!name.empty() && !name.ends_with('/') && !name.ends_with('\\')) names.push_back(name);
  }
  return names;
}

Result<InputFile> ZipArchive::unpacked(const std::string& entry) const {
  const Result<XmlScanner::ByteSource> bytes = bytes_of(entry);
  if (!bytes.ok()) return bytes.error();
  Result<UnnamedFile> file = UnnamedFile::create();
  if (!file.ok()) return file.error();
  std::vector<char> piece(kPieceBytes);
  while (true) {
    const Result<std::size_t> count = bytes.value()(piece.data(), piece.size());
    if (!count.ok()) return count.error();
    if (count.value() == 0) break;
    if (core::Status added = file.value().append({piece.data(), count.value()}); !added.ok()) {
      return added.error();
    }
  }
  return InputFile::from_descriptor(state_->name + " (" + entry + ")", file.value().release());
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
