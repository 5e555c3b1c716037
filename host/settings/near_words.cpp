#include "host/settings/near_words.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace host {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t exchanged = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({exchanged, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

void NearestWord::look_at(std::string_view candidate) {
  // Words that differ by more than this are not confused.
  const std::size_t farthest = std::min<std::size_t>(3, typed_.size() / 3);
  const std::size_t longer = std::max(candidate.size(), typed_.size());
  if (longer - std::min(candidate.size(), typed_.size()) > farthest) return;
  const std::size_t distance = edit_distance(typed_, candidate);
  if (distance > farthest || distance >= distance_) return;
  word_ = candidate;
  distance_ = distance;
}

}  // namespace host
