#include "host/printing/journal_directory.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <utility>

#include "host/files/content_hash.h"  // hash_of

namespace host {
namespace {

constexpr std::string_view kEnding = ".journal";
// Of the part's name in the journal's: with all that comes behind it, a file's name is at most
// 255 bytes long.
constexpr std::size_t kNameBytesMax = 160;

std::string whole_path(const std::string& path) {
  std::error_code error;
  return std::filesystem::weakly_canonical(path, error).string();
}

// Shortened at the start of a character.
std::string shortened(std::string name) {
  if (name.size() <= kNameBytesMax) return name;
  std::size_t end = kNameBytesMax;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) --end;
  name.resize(end);
  return name;
}

bool ends_with(std::string_view name, std::string_view end) {
  return name.size() >= end.size() && name.substr(name.size() - end.size()) == end;
}

std::time_t written_at(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? status.st_mtime : 0;
}

}  // namespace

std::string journal_directory() {
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  if (state != nullptr && *state == '/') return std::string(state) + "/rind";
  if (home != nullptr && *home == '/') return std::string(home) + "/.local/state/rind";
  return {};
}

std::string default_journal_path(const std::string& part, int number) {
  const std::string folder = journal_directory();
  if (folder.empty()) return {};
  const std::string whole = whole_path(part);
  return fmt::format("{}/{}-{:08x}{}{}", folder,
                     shortened(std::filesystem::path(whole).filename().string()),
                     static_cast<std::uint32_t>(hash_of(whole)),
                     number > 1 ? fmt::format("-{}", number) : "", kEnding);
}

std::optional<FoundJournal> find_journal(const std::string& path) {
  const JournalStanding standing = look_at_journal(path).standing;
  if (standing != JournalStanding::kResumable && standing != JournalStanding::kHeld) {
    return std::nullopt;
  }
  FoundJournal found{path, standing, std::nullopt, {}, written_at(path)};
  const core::Result<JournalContent> read = read_journal(path);
  if (read.ok()) {
    found.content = read.value();
  } else {
    found.why = read.error().message;
  }
  return found;
}

std::vector<FoundJournal> find_journals() {
  std::vector<std::pair<std::time_t, std::string>> names;
  std::error_code error;
  for (std::filesystem::directory_iterator at(journal_directory(), error), end; !error && at != end;
       at.increment(error)) {
    const std::string path = at->path().string();
    if (ends_with(path, kEnding) || ends_with(path, set_aside_name(std::string(kEnding)))) {
      names.emplace_back(written_at(path), path);
    }
  }
  std::sort(names.rbegin(), names.rend());
  if (names.size() > kJournalsListedMax) names.resize(kJournalsListedMax);
  std::vector<FoundJournal> journals;
  for (const auto& [unused, path] : names) {
    if (auto found = find_journal(path)) journals.push_back(std::move(*found));
  }
  return journals;
}

bool is_of_part(const FoundJournal& journal, const std::string& part) {
  return journal.content && whole_path(journal.content->head.part) == whole_path(part);
}

JournalChoice choose_journal(const std::string& part) {
  JournalChoice choice;
  for (int number = 1; number <= kPrintsOfOnePartMax; ++number) {
    const std::string path = default_journal_path(part, number);
    if (path.empty()) return choice;
    const JournalStanding standing = look_at_journal(path).standing;
    if (standing == JournalStanding::kAbsent || standing == JournalStanding::kEmpty) {
      if (choice.path.empty()) choice.path = path;
      continue;
    }
    if (standing != JournalStanding::kResumable) continue;
    std::optional<FoundJournal> found = find_journal(path);
    // Another part's path may have the same sum.
    if (found && (!found->content || is_of_part(*found, part))) {
      choice.interrupted.push_back(std::move(*found));
    }
  }
  return choice;
}

std::string layer_text(const JournalRecord& record) {
  const std::string of = record.layers > 0 ? fmt::format(" of {}", record.layers) : "";
  return fmt::format("layer {}{}", record.checkpoint.layer + 1, of);
}

std::string state_text(PrintState state) {
  switch (state) {
    case PrintState::kRunning:
      return "rind or its computer died";
    case PrintState::kStopped:
      return "it was stopped";
    case PrintState::kReset:
      return "the controller was reset or halted";
    case PrintState::kPortLost:
      return "the port was lost";
    case PrintState::kLinkFault:
      return "the controller did not answer any more";
  }
  return "interrupted";
}

std::string time_text(std::time_t time) {
  std::tm local{};
  if (::localtime_r(&time, &local) == nullptr) return "unknown";
  std::array<char, 32> text{};
  const std::size_t size = std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &local);
  return {text.data(), size};
}

}  // namespace host
