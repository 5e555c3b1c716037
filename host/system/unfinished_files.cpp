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

struct Slot {
  std::atomic<int> state = kFree;
  std::array<char, PATH_MAX> path{};
};

std::array<Slot, kUnfinishedFilesMax> g_slots;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not wait for a lock");

}  // namespace

UnfinishedFile::UnfinishedFile(const std::string& path) {
  if (path.size() >= PATH_MAX) return;
  for (std::size_t i = 0; i < g_slots.size(); ++i) {
    int free = kFree;
    if (!g_slots[i].state.compare_exchange_strong(free, kBeingSet)) continue;
    std::copy_n(path.c_str(), path.size() + 1, g_slots[i].path.begin());
    g_slots[i].state.store(kSet);
    slot_ = static_cast<int>(i);
    return;
  }
}

UnfinishedFile::~UnfinishedFile() {
  if (slot_ >= 0) g_slots[static_cast<std::size_t>(slot_)].state.store(kFree);
}

void remove_unfinished_files() {
  for (const Slot& slot : g_slots) {
    if (slot.state.load() == kSet) (void)::unlink(slot.path.data());
  }
}

}  // namespace host
