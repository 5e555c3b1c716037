#include "host/system/memory_budget.h"

#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "host/system/limits.h"  // kMemoryReserveBytes, kMemoryUnsettledBytes

namespace host {
namespace {

std::atomic<std::int64_t> g_limit = 0;    // 0: none
std::atomic<std::int64_t> g_used = 0;     // allocated and not freed
std::atomic<std::int64_t> g_base = 0;     // resident besides g_used
std::atomic<std::int64_t> g_refused = 0;  // use that the last refused allocation would have led to

thread_local std::int64_t t_allocations = 0;
thread_local std::int64_t t_unsettled = 0;

std::int64_t resident_bytes() {
  std::int64_t total_pages = 0, resident_pages = 0;
  std::FILE* file = std::fopen("/proc/self/statm", "re");
  if (file == nullptr) return 0;
  if (std::fscanf(file, "%ld %ld", &total_pages, &resident_pages) != 2) resident_pages = 0;
  std::fclose(file);
  return resident_pages * sysconf(_SC_PAGESIZE);
}

// Each thread first counts for itself, so that threads don't contend at every allocation.
void settle(std::int64_t bytes) noexcept {
  t_unsettled += bytes;
  if (std::abs(t_unsettled) < kMemoryUnsettledBytes) return;
  g_used.fetch_add(t_unsettled, std::memory_order_relaxed);
  t_unsettled = 0;
}

bool has_limit() { return g_limit.load(std::memory_order_relaxed) != 0; }

std::int64_t size_of(void* memory) { return static_cast<std::int64_t>(malloc_usable_size(memory)); }

double megabytes(std::int64_t bytes) { return static_cast<double>(bytes) * 1e-6; }

}  // namespace

void set_heaps(int threads) {
#ifdef __GLIBC__
  mallopt(M_ARENA_MAX, threads);
#else
  static_cast<void>(threads);
#endif
}

void set_memory_limit(std::int64_t bytes) {
  g_base.store(std::max<std::int64_t>(0, resident_bytes() - g_used.load()));
  g_limit.store(bytes);
}

bool memory_allowed(std::size_t bytes) noexcept {
  const std::int64_t limit = g_limit.load(std::memory_order_relaxed);
  if (limit == 0) return true;
  const std::int64_t would_be = g_base.load(std::memory_order_relaxed) +
                                g_used.load(std::memory_order_relaxed) +
                                static_cast<std::int64_t>(bytes);
  const bool small = bytes <= kMemorySmallBytes;
  if (would_be <= limit + (small ? kMemoryReserveBytes : 0)) return true;
  g_refused.store(would_be);
  return false;
}

void memory_taken(void* memory) noexcept {
  ++t_allocations;
  if (has_limit()) settle(size_of(memory));
}

std::int64_t thread_allocations() noexcept { return t_allocations; }

void memory_given_back(void* memory) noexcept {
  if (has_limit()) settle(-size_of(memory));
}

bool take_file_memory(std::int64_t bytes) noexcept {
  if (!memory_allowed(static_cast<std::size_t>(bytes))) return false;
  g_used.fetch_add(bytes, std::memory_order_relaxed);
  return true;
}

void give_back_file_memory(std::int64_t bytes) noexcept {
  g_used.fetch_sub(bytes, std::memory_order_relaxed);
}

std::string memory_refusal() {
  const std::int64_t limit = g_limit.exchange(0), refused = g_refused.load();
  if (refused > 0 && limit > 0) {
    return fmt::format("{:.1f} MB of memory are needed, {:.1f} MB allowed (--memory-limit)",
                       megabytes(refused), megabytes(limit));
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return fmt::format("the system gives no more memory; {:.1f} MB were in use",
                     megabytes(std::int64_t{usage.ru_maxrss} * 1'024));
}

}  // namespace host
