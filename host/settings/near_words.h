// The word that somebody may have meant.
#pragma once

#include <cstddef>
#include <limits>
#include <string_view>

namespace host {

// Of all candidates the most similar one, the first of equally similar ones; none if all differ too
// much to be confused.
class NearestWord {
 public:
  // `typed` outlives it, as the candidates do.
  explicit NearestWord(std::string_view typed) : typed_(typed) {}

  void look_at(std::string_view candidate);

  // Empty: none is similar.
  [[nodiscard]] std::string_view word() const { return word_; }
  // Letters to insert, delete or replace (Levenshtein 1966).
  [[nodiscard]] std::size_t distance() const { return distance_; }

 private:
  std::string_view typed_;
  std::string_view word_;
  std::size_t distance_ = std::numeric_limits<std::size_t>::max();
};

}  // namespace host
