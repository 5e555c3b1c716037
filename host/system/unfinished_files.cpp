#include "host/system/unfinished_files.h"

#include <limits.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>

#include "host/system/limits.h"  // kUnfinishedFilesMax

namespace host {
namespace {

enum State : int { kFree, kBeingSet, kSet };

struct Place {
  std::atomic<int> state = kFree;
  std::array<char, PATH_MAX> path{};
};

std::array<Place, kUnfinishedFilesMax> g_places;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not wait for a lock");

}  // namespace

UnfinishedFile::UnfinishedFile(const std::string& path) {
  if (path.size() >= PATH_MAX) return;
  for (std::size_t i = 0; i < g_places.size(); ++i) {
    int free = kFree;
    if (!g_places[i].state.compare_exchange_strong(free, kBeingSet)) continue;
    std::copy_n(path.c_str(), path.size() + 1, g_places[i].path.begin());
    g_places[i].state.store(kSet);
    place_ = static_cast<int>(i);
    return;
  }
}

UnfinishedFile::~UnfinishedFile() {
  if (place_ >= 0) g_places[static_cast<std::size_t>(place_)].state.store(kFree);
}

void remove_unfinished_files() {
  for (const Place& place : g_places) {
    if (place.state.load() == kSet) (void)::unlink(place.path.data());
  }
}

}  // namespace host
