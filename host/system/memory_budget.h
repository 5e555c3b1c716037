// The program's memory limit. A program that reaches it reports what it lacks instead of being
// killed by the system.
//
//     resident when the limit was set  +  what was allocated since  <=  the limit
//
// The program's operator new asks memory_allowed() (memory_hook.cpp, not in tests) and throws
// std::bad_alloc if the answer is no. The pipeline turns that into an error with the layer, the
// memory needed and the limit. Small allocations may exceed the limit by kMemoryReserveBytes, so
// that the link can still stop the printer safely.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace host {

// Lets the C library have a heap for each of these threads, and no more. Two threads that share
// one wait for one another: with one heap, two threads were no faster than one on the tower, and
// took 1.7 times its processor time (tools/bench_threads).
// REQUIRES: called before any other thread runs; threads >= 1
void set_heaps(int threads);

// Counting starts here. 0: no limit.
void set_memory_limit(std::int64_t bytes);

// For the hook: may so many bytes be allocated; this was allocated; this is about to be freed.
// Called by any thread. None of them allocates. Without a limit, sizes are not asked for: that
// takes 2 % of a slicing's time.
[[nodiscard]] bool memory_allowed(std::size_t bytes) noexcept;
void memory_taken(void* memory) noexcept;
void memory_given_back(void* memory) noexcept;

// The same for memory that the program uses without allocating it: files that are kept in memory.
// False: it would exceed the limit, and is not counted.
[[nodiscard]] bool take_file_memory(std::int64_t bytes) noexcept;
void give_back_file_memory(std::int64_t bytes) noexcept;

// Allocations of the calling thread since it started; 0 if no hook counts them.
[[nodiscard]] std::int64_t thread_allocations() noexcept;

// Why the last allocation was refused, for people: "12.3 MB of memory are needed, 10.0 MB allowed
// (--memory-limit)", or that the system had no more. This call removes the limit: the caller is
// about to end and needs a little memory to say why.
[[nodiscard]] std::string memory_refusal();

}  // namespace host
