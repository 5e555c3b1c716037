// What `rind setup` asks its user. Where nobody can answer, the usual answer is taken, and a
// question without one is an error that names the option to give instead.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"             // Result
#include "host/printing/controls.h"  // Controls

namespace host {

class SetupQuestions {
 public:
  // `asks`: there may be somebody to ask.
  explicit SetupQuestions(bool asks) : asks_(asks), controls_(false) {}

  // Which of the lines; the only one is not asked for.
  [[nodiscard]] core::Result<std::size_t> one_of(const std::string& question,
                                                 const std::vector<std::string>& lines);

  // One of the names; `usual` for an empty answer.
  [[nodiscard]] core::Result<std::string> named(const std::string& question,
                                                const std::vector<std::string>& names,
                                                const std::string& usual);

  // A length above 0 in mm. `usual` may be empty; `key` is the setting that it is for.
  [[nodiscard]] core::Result<double> number(const std::string& question, const std::string& usual,
                                            const std::string& key);

  // Only if somebody says so.
  [[nodiscard]] bool agreed(const std::string& question);

 private:
  [[nodiscard]] std::optional<std::string> answer(const std::string& question);

  bool asks_;
  Controls controls_;
};

}  // namespace host
