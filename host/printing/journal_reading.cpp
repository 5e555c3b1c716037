// A journal's bytes: the head's text, and which record counts.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "host/files/content_hash.h"  // hash_of
#include "host/files/input_file.h"
#include "host/printing/journal.h"
#include "host/printing/journal_file.h"  // kJournalWord

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using Json = nlohmann::ordered_json;

// "rind journal 6 0123456789abcdef 00001234\n": form, checksum and length of what follows.
constexpr std::string_view kMark = "rind journal 6 ";
constexpr std::size_t kSumDigits = 16;
constexpr std::size_t kLengthDigits = 8;
constexpr std::size_t kFirstLineBytes = kMark.size() + kSumDigits + 1 + kLengthDigits + 1;

std::size_t rounded_up(std::size_t bytes) {
  return (bytes + kJournalBlockBytes - 1) / kJournalBlockBytes * kJournalBlockBytes;
}

Error unusable(const std::string& name, const std::string& why) {
  return {ErrorCode::kUnreadable, name + ": " + why};
}

std::optional<std::uint64_t> number_in(std::string_view digits, int base) {
  std::uint64_t value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

JournalHead head_in(const Json& json) {
  JournalHead head;
  head.version = json.at("version").get<std::string>();
  head.part = json.at("part").get<std::string>();
  head.more_parts = json.at("more_parts").get<std::vector<std::string>>();
  head.part_title = json.at("part_title").get<std::string>();
  head.part_hash = number_in(json.at("part_hash").get<std::string>(), 16).value_or(0);
  head.part_bytes = json.at("part_bytes").get<std::int64_t>();
  for (const auto& [key, value] : json.at("settings").items()) {
    head.settings.emplace_back(key, value.get<std::string>());
  }
  head.on_bad_layer = json.at("on_bad_layer").get<std::string>();
  head.on_floating = json.at("on_floating").get<std::string>();
  head.port = json.at("port").get<std::string>();
  head.usb = json.at("usb").get<std::string>();
  head.baud = json.at("baud").get<int>();
  head.boot = json.at("boot").get<std::string>();
  return head;
}

}  // namespace

std::string head_bytes(const JournalHead& head) {
  Json json = {{"version", head.version},
               {"part", head.part},
               {"more_parts", head.more_parts},
               {"part_title", head.part_title},
               {"part_hash", fmt::format("{:016x}", head.part_hash)},
               {"part_bytes", head.part_bytes},
               {"on_bad_layer", head.on_bad_layer},
               {"on_floating", head.on_floating},
               {"port", head.port},
               {"usb", head.usb},
               {"baud", head.baud},
               {"boot", head.boot},
               {"settings", Json::object()}};
  for (const auto& [key, value] : head.settings) json["settings"][key] = value;
  // Names of files may hold anything.
  const std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  std::string bytes = fmt::format("{}{:016x} {:08}\n", kMark, hash_of(text), text.size()) + text;
  bytes.resize(rounded_up(bytes.size()), '\n');
  return bytes;
}

namespace {

// What of a journal is whole.
struct WholeParts {
  JournalHead head;
  std::optional<SequencedRecord> newest;
};

Result<WholeParts> whole_parts_of(const std::string& bytes, const std::string& name) {
  const std::string_view all(bytes);
  if (all.substr(0, kMark.size()) != kMark || all.size() < kFirstLineBytes) {
    return unusable(name, all.substr(0, kJournalWord.size()) == kJournalWord
                              ? "a journal of another version of rind; use that one"
                              : "this is no journal of rind's");
  }
  const auto sum = number_in(all.substr(kMark.size(), kSumDigits), 16);
  const auto length = number_in(all.substr(kMark.size() + kSumDigits + 1, kLengthDigits), 10);
  if (!sum || !length || *length > all.size() - kFirstLineBytes ||
      hash_of(all.substr(kFirstLineBytes, *length)) != *sum) {
    return unusable(name, "the journal's head is damaged; the print can't be resumed from it");
  }
  const Json json = Json::parse(all.substr(kFirstLineBytes, *length), nullptr, false);
  WholeParts parts;
  try {
    parts.head = head_in(json);
  } catch (const Json::exception&) {
    return unusable(name, "a journal of another version of rind; use that one");
  }
  const std::size_t records_at = rounded_up(kFirstLineBytes + *length);
  for (std::size_t slot = 0; slot < kJournalRecords; ++slot) {
    const std::size_t at = records_at + slot * kJournalBlockBytes;
    if (at >= all.size()) break;
    const std::optional<SequencedRecord> read = read_record(all.substr(at));
    if (read && (!parts.newest || read->sequence > parts.newest->sequence)) parts.newest = read;
  }
  return parts;
}

Result<std::string> bytes_of(const std::string& path) {
  Result<InputFile> opened = InputFile::open(path);
  if (!opened.ok()) return opened.error();
  InputFile& file = opened.value();
  std::string bytes;
  while (bytes.size() < kJournalHeadBytesMax + kJournalRecords * kJournalBlockBytes) {
    const Result<std::string_view> window = file.window(1);
    if (!window.ok()) return window.error();
    if (window.value().empty()) break;
    bytes += window.value();
    file.skip(window.value().size());
  }
  return bytes;
}

}  // namespace

Result<JournalContent> read_journal_bytes(const std::string& bytes, const std::string& name) {
  const Result<WholeParts> parts = whole_parts_of(bytes, name);
  if (!parts.ok()) return parts.error();
  if (!parts.value().newest) {
    return unusable(
        name, "the print was interrupted before its first road: print the part from the start");
  }
  return JournalContent{parts.value().head, parts.value().newest->record};
}

Result<JournalContent> read_journal(const std::string& path) {
  const Result<std::string> bytes = bytes_of(path);
  if (!bytes.ok()) return bytes.error();
  return read_journal_bytes(bytes.value(), path);
}

bool is_empty_journal(const std::string& path) {
  const Result<std::string> bytes = bytes_of(path);
  if (!bytes.ok()) return false;
  const Result<WholeParts> parts = whole_parts_of(bytes.value(), path);
  return parts.ok() && !parts.value().newest;
}

}  // namespace host
