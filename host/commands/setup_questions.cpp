#include "host/commands/setup_questions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/settings/settings_text.h"  // read_number
#include "host/system/stop_signals.h"
#include "host/system/text.h"  // trimmed

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

// A wrong answer is asked for again, so often at most.
constexpr int kTriesMax = 10;

Error nobody(const std::string& question, const std::string& instead) {
  return {ErrorCode::kBadSetting, fmt::format("nobody answered \"{}\"; {}", question, instead)};
}

}  // namespace

std::optional<std::string> SetupQuestions::answer(const std::string& question) {
  if (!asks_ || stop_signal_count() > 0) return std::nullopt;
  std::optional<std::string> said = controls_.ask(question, [] { return stop_signal_count() > 0; });
  if (said) *said = std::string(trimmed(*said));
  return said;
}

Result<std::size_t> SetupQuestions::one_of(const std::string& question,
                                           const std::vector<std::string>& lines) {
  if (lines.size() == 1) return std::size_t{0};
  std::string whole = question;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    whole += fmt::format("\n  {}  {}", i + 1, lines[i]);
  }
  for (int i = 0; i < kTriesMax; ++i) {
    const std::optional<std::string> said = answer(whole + "\nIts number:");
    if (!said) break;
    const Result<std::int64_t> number = read_whole_number(*said);
    const auto count = static_cast<std::int64_t>(lines.size());
    if (number.ok() && number.value() >= 1 && number.value() <= count) {
      return static_cast<std::size_t>(number.value() - 1);
    }
  }
  return nobody(whole, "name it by --port");
}

Result<std::string> SetupQuestions::named(const std::string& question,
                                          const std::vector<std::string>& names,
                                          const std::string& usual) {
  const std::string whole =
      fmt::format("{} {}\nEnter for {}:", question, fmt::join(names, ", "), usual);
  for (int i = 0; i < kTriesMax; ++i) {
    const std::optional<std::string> said = answer(whole);
    if (!said || said->empty()) break;
    if (std::find(names.begin(), names.end(), *said) != names.end()) return *said;
  }
  return usual;
}

Result<double> SetupQuestions::number(const std::string& question, const std::string& usual,
                                      const std::string& key) {
  const std::string whole =
      question +
      (usual.empty() ? "" : fmt::format(" Enter for {}, as the controller says:", usual));
  for (int i = 0; i < kTriesMax; ++i) {
    std::optional<std::string> said = answer(whole);
    if (!said || said->empty()) said = usual;
    Result<double> number = read_number(*said, "mm");
    if (number.ok() && number.value() > 0) return number;
    if (!asks_ || stop_signal_count() > 0) break;
  }
  return nobody(question, fmt::format("say it by --set {}=MM", key));
}

bool SetupQuestions::agreed(const std::string& question) {
  const std::optional<std::string> said = answer(question + " y for yes:");
  return said && (*said == "y" || *said == "yes");
}

}  // namespace host
