// The program's own operator new and delete, which count memory (memory_budget.h).
#include <cstdlib>
#include <new>

#include "host/system/memory_budget.h"

void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  if (!host::memory_allowed(bytes)) return nullptr;
  void* memory = std::malloc(bytes > 0 ? bytes : 1);
  if (memory != nullptr) host::memory_taken(memory);
  return memory;
}

void* operator new(std::size_t bytes) {
  if (void* memory = operator new(bytes, std::nothrow)) return memory;
  throw std::bad_alloc();
}

void* operator new[](std::size_t bytes) { return operator new(bytes); }

void operator delete(void* memory) noexcept {
  if (memory == nullptr) return;
  host::memory_given_back(memory);
  std::free(memory);
}

void operator delete[](void* memory) noexcept { operator delete(memory); }
void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }
void operator delete[](void* memory, std::size_t) noexcept { operator delete(memory); }
