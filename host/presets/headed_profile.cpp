#include "host/presets/headed_profile.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/system/text.h"  // trimmed

namespace host {
namespace {

using core::Error;
using core::ErrorCode;

bool is_comment(std::string_view line) {
  return line.empty() || line.front() == '#' || line.front() == ';';
}

std::string listed(std::span<const std::string_view> keys) {
  std::string text;
  for (const std::string_view key : keys)
    text += fmt::format("{}{}", text.empty() ? "" : ", ", key);
  return text;
}

class HeadReader {
 public:
  HeadReader(const std::string& name, std::string_view section,
             std::span<const std::string_view> keys)
      : name_(name), section_(section), keys_(keys) {}

  // The head's next line.
  core::Status take(std::string_view line, int number) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) {
      return error(number, "neither \"key = value\" nor [section] nor a comment");
    }
    const std::string_view key = trimmed(line.substr(0, equals));
    if (std::find(keys_.begin(), keys_.end(), key) == keys_.end()) {
      return error(number, fmt::format("\"{}\" is not known in [{}]; known are {}; settings come "
                                       "behind a line [rind]",
                                       key, section_, listed(keys_)));
    }
    const auto [at, added] = profile_.head.emplace(key, trimmed(line.substr(equals + 1)));
    return added ? core::Status() : error(number, fmt::format("\"{}\" is there twice", key));
  }

  HeadedProfile& profile() { return profile_; }

 private:
  core::Status error(int number, const std::string& message) const {
    return Error{ErrorCode::kBadSetting, fmt::format("{}:{}: {}", name_, number, message)};
  }

  const std::string& name_;
  std::string_view section_;
  std::span<const std::string_view> keys_;
  HeadedProfile profile_;
};

}  // namespace

std::string_view HeadedProfile::value(std::string_view key) const {
  const auto found = head.find(key);
  return found == head.end() ? std::string_view() : std::string_view(found->second);
}

core::Result<HeadedProfile> read_headed_profile(std::string_view text, const std::string& name,
                                                std::string_view section,
                                                std::span<const std::string_view> keys) {
  HeadReader reader(name, section, keys);
  const std::string opening = fmt::format("[{}]", section);
  bool in_head = false;
  int number = 0;
  while (!text.empty()) {
    ++number;
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    const std::string_view whole = text.substr(0, end + 1);
    text.remove_prefix(whole.size());
    const std::string_view line = trimmed(whole.substr(0, whole.find('\n')));
    if (!line.empty() && line.front() == '[') in_head = line == opening;
    if (!in_head) {
      reader.profile().settings += whole;
      continue;
    }
    reader.profile().settings += '\n';
    if (is_comment(line) || line == opening) continue;
    if (core::Status taken = reader.take(line, number); !taken.ok()) return taken.error();
  }
  return std::move(reader.profile());
}

}  // namespace host
