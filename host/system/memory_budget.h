// How much memory the program may use, so that it says what it lacks instead of being killed.
//
//     resident when the limit was set  +  what was allocated since  <=  the limit
//
// The program's operator new asks here (memory_hook.cpp, in the program only); what does not fit
// throws std::bad_alloc, which the pipeline turns into an error that names the layer, the need and
// the limit. Small pieces may go beyond it by kMemoryReserveBytes, so that the link can still bring
// the printer to a safe end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace host {

// The library's allocator keeps what is freed in a heap for each thread, of which every one grows
// to its thread's worst layer. One for two threads is enough (tower: no processor time lost).
// REQUIRES: called before any other thread runs; jobs >= 1
void share_heaps(int jobs);

// Counts from here on; 0: no limit.
void set_memory_limit(std::int64_t bytes);

// From the hook: whether it may be had, and what was. Any thread; neither allocates.
[[nodiscard]] bool memory_allowed(std::size_t bytes) noexcept;
void memory_taken(std::size_t bytes) noexcept;
void memory_given_back(std::size_t bytes) noexcept;

// Allocations of the calling thread since it began; 0 where no hook counts them.
[[nodiscard]] std::int64_t thread_allocations() noexcept;

// What was missing when an allocation was refused last, for people: "12.3 MB of memory are needed,
// 10.0 MB allowed (--memory-limit)", or that the system had no more. The limit ends with this call:
// who asks is about to end, and needs a little memory to say why.
[[nodiscard]] std::string memory_refusal();

}  // namespace host
