#include "core/motions/fan_plan.h"

#include <algorithm>
#include <utility>

namespace core {
namespace {

struct Run {
  std::size_t first = 0, end = 0;  // ways
  double wanted_mm = 0;            // of the ways that want more
  double gap_mm = 0;               // laid between the run before and this one
  double share = 0;
};

std::vector<Run> runs_of(double layer_share, const std::vector<FanWish>& ways) {
  std::vector<Run> runs;
  double gap_mm = 0;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    if (ways[i].share <= layer_share) {
      gap_mm += ways[i].length_mm;
      continue;
    }
    if (runs.empty() || gap_mm > 0) runs.push_back({i, i, 0, gap_mm, 0});
    gap_mm = 0;
    runs.back().end = i + 1;
    runs.back().wanted_mm += ways[i].length_mm;
    runs.back().share = std::max(runs.back().share, ways[i].share);
  }
  return runs;
}

// Joins neighbours with less between them than `gap_mm`.
std::vector<Run> joined(const std::vector<Run>& runs, double gap_mm) {
  std::vector<Run> result;
  for (const Run& run : runs) {
    if (result.empty() || run.gap_mm >= gap_mm) {
      result.push_back(run);
      continue;
    }
    result.back().end = run.end;
    result.back().wanted_mm += run.wanted_mm;
    result.back().share = std::max(result.back().share, run.share);
  }
  return result;
}

void drop_short(std::vector<Run>& runs) {
  std::vector<Run> result;
  double gap_mm = 0;
  for (const Run& run : runs) {
    gap_mm += run.gap_mm;
    if (run.wanted_mm < kFanRunMin_mm) {
      gap_mm += run.wanted_mm;
      continue;
    }
    result.push_back(run);
    result.back().gap_mm = gap_mm;
    gap_mm = 0;
  }
  runs = std::move(result);
}

// The narrowest gaps are closed, of equal ones the last, until kFanRunsMax runs are left.
void limit(std::vector<Run>& runs) {
  if (runs.size() <= kFanRunsMax) return;
  std::vector<std::size_t> widest;  // runs by the gap before them
  for (std::size_t i = 1; i < runs.size(); ++i) widest.push_back(i);
  std::stable_sort(widest.begin(), widest.end(),
                   [&](std::size_t a, std::size_t b) { return runs[a].gap_mm > runs[b].gap_mm; });
  for (std::size_t i = kFanRunsMax - 1; i < widest.size(); ++i) runs[widest[i]].gap_mm = -1;
  runs = joined(runs, 0);
}

}  // namespace

std::vector<double> fan_plan(double layer_share, const std::vector<FanWish>& ways) {
  std::vector<double> shares(ways.size(), layer_share);
  std::vector<Run> runs = joined(runs_of(layer_share, ways), kFanGapMin_mm);
  drop_short(runs);
  limit(runs);
  for (const Run& run : runs) {
    for (std::size_t i = run.first; i < run.end; ++i) shares[i] = run.share;
  }
  return shares;
}

}  // namespace core
