#include "host/commands/resume_choice.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "host/commands/commands.h"
#include "host/files/content_hash.h"          // contents_of
#include "host/printing/journal_directory.h"  // find_journals

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

// Journals that a message names, at most.
constexpr std::size_t kNamedMax = 8;

std::string state_of_part(const JournalHead& head) {
  std::error_code error;
  std::vector<std::string> paths = head.more_parts;
  paths.insert(paths.begin(), head.part);
  std::uintmax_t bytes = 0;
  for (const std::string& path : paths) {
    if (!std::filesystem::is_regular_file(path, error)) return "missing";
    bytes += std::filesystem::file_size(path, error);
    if (error) return "changed";
  }
  if (bytes != static_cast<std::uintmax_t>(head.part_bytes)) return "changed";
  const Result<FileContent> content = contents_of(paths);
  if (!content.ok()) return "unreadable";
  return content.value().hash == head.part_hash ? "unchanged" : "changed";
}

// A word for programs.
std::string standing_of(const FoundJournal& journal) {
  if (journal.standing == JournalStanding::kHeld) return "printing";
  return journal.content ? "cut" : "unreadable";
}

nlohmann::ordered_json json_of(const FoundJournal& journal) {
  nlohmann::ordered_json json = {{"journal", journal.path},
                                 {"state", standing_of(journal)},
                                 {"when", time_text(journal.written)}};
  if (!journal.content) {
    if (journal.standing != JournalStanding::kHeld) json["why"] = journal.why;
    return json;
  }
  const JournalHead& head = journal.content->head;
  const JournalRecord& record = journal.content->record;
  json["part"] = head.part;
  json["part_state"] = state_of_part(head);
  json["layer"] = record.checkpoint.layer + 1;
  json["layers"] = record.layers;
  json["cause"] = state_text(record.state);
  json["port"] = head.port;
  return json;
}

std::string text_of(const FoundJournal& journal) {
  if (journal.standing == JournalStanding::kHeld) {
    const std::string part = journal.content ? journal.content->head.part_title + ": " : "";
    return fmt::format("{}being printed\n  journal  {}", part, journal.path);
  }
  if (!journal.content) return fmt::format("can't be resumed: {}", journal.why);
  const JournalHead& head = journal.content->head;
  const JournalRecord& record = journal.content->record;
  return fmt::format("{}: {}, {} ({})\n  part     {} ({})\n  journal  {}", head.part_title,
                     layer_text(record), time_text(journal.written), state_text(record.state),
                     head.part, state_of_part(head), journal.path);
}

bool same_path(const std::string& a, const std::string& b) {
  std::error_code error;
  return std::filesystem::weakly_canonical(a, error) == std::filesystem::weakly_canonical(b, error);
}

std::string named_ones(const std::vector<FoundJournal>& journals) {
  std::string text;
  for (std::size_t i = 0; i < journals.size() && i < kNamedMax; ++i) {
    text += "\n" + text_of(journals[i]);
  }
  if (journals.size() > kNamedMax) {
    text += fmt::format("\nand {} more: rind resume", journals.size() - kNamedMax);
  }
  return text;
}

// By its whole path, or else by its file's name.
std::vector<FoundJournal> journals_of(const std::string& name,
                                      const std::vector<FoundJournal>& all) {
  std::vector<FoundJournal> by_path;
  std::vector<FoundJournal> by_name;
  for (const FoundJournal& journal : all) {
    if (!journal.content) continue;
    const JournalHead& head = journal.content->head;
    if (same_path(head.part, name)) by_path.push_back(journal);
    if (std::filesystem::path(head.part).filename() == name) by_name.push_back(journal);
  }
  return by_path.empty() ? by_name : by_path;
}

bool is_set_aside(const FoundJournal& journal) {
  const std::string end = set_aside_name("");
  return journal.path.size() > end.size() &&
         journal.path.compare(journal.path.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

int list_journals(const Options& options, Reporter& reporter) {
  const std::vector<FoundJournal> journals = find_journals();
  std::string text;
  if (options.json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const FoundJournal& journal : journals) list.push_back(json_of(journal));
    text = list.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    return show_result(text, reporter);
  }
  for (const FoundJournal& journal : journals) text += text_of(journal) + "\n";
  if (journals.empty()) text = "no print was interrupted: there is nothing to resume\n";
  return show_result(text, reporter);
}

Result<std::string> journal_named(const std::string& name) {
  std::error_code error;
  const JournalLook look = look_at_journal(name);
  if (look.standing == JournalStanding::kResumable || look.standing == JournalStanding::kEmpty ||
      look.standing == JournalStanding::kHeld) {
    return name;
  }
  // The name of a journal may be a link; that of a part has no journal's content.
  if (std::filesystem::is_symlink(name, error)) {
    const std::string real = std::filesystem::canonical(name, error).string();
    if (!error && look_at_journal(real).standing != JournalStanding::kForeign) return real;
  }
  const std::vector<FoundJournal> all = find_journals();
  const std::vector<FoundJournal> known = journals_of(name, all);
  std::vector<FoundJournal> interrupted;
  for (const FoundJournal& journal : known) {
    if (journal.standing != JournalStanding::kHeld && !is_set_aside(journal))
      interrupted.push_back(journal);
  }
  if (interrupted.size() == 1) return interrupted.front().path;
  if (interrupted.empty() && known.size() == 1) return known.front().path;
  if (!known.empty()) {
    return Error{ErrorCode::kUnreadable, name +
                                             ": several prints of it can be resumed; name the "
                                             "journal of one:" +
                                             named_ones(known)};
  }
  return Error{ErrorCode::kUnreadable,
               name + ": this is no journal, and no print of such a part was interrupted; " +
                   (all.empty() ? "there is nothing to resume" : "there are:" + named_ones(all))};
}

}  // namespace host
