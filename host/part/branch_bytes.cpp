#include "host/part/branch_bytes.h"

#include <cstddef>
#include <cstring>

#include "core/check.h"  // RIND_CHECK

namespace host {
namespace {

// Both ends, and a byte: 1, the first is at the wall, 2, the second.
constexpr std::size_t kBranchBytes = 2 * sizeof(core::Point) + 1;

}  // namespace

std::string branch_bytes(const core::Branches& branches) {
  std::string bytes(branches.size() * kBranchBytes, '\0');
  char* at = bytes.data();
  for (const core::Branch& branch : branches) {
    std::memcpy(at, &branch.from, sizeof(core::Point));
    std::memcpy(at + sizeof(core::Point), &branch.to, sizeof(core::Point));
    at[kBranchBytes - 1] = static_cast<char>((branch.from_wall ? 1 : 0) | (branch.to_wall ? 2 : 0));
    at += kBranchBytes;
  }
  return bytes;
}

core::Branches branches_in(std::string_view bytes) {
  RIND_CHECK(bytes.size() % kBranchBytes == 0);
  core::Branches branches(bytes.size() / kBranchBytes);
  const char* at = bytes.data();
  for (core::Branch& branch : branches) {
    std::memcpy(&branch.from, at, sizeof(core::Point));
    std::memcpy(&branch.to, at + sizeof(core::Point), sizeof(core::Point));
    branch.from_wall = (at[kBranchBytes - 1] & 1) != 0;
    branch.to_wall = (at[kBranchBytes - 1] & 2) != 0;
    at += kBranchBytes;
  }
  return branches;
}

}  // namespace host
