// One writer for a name at a time, among the programs of this computer.
//
// The lock is a socket's name in the kernel (abstract, no file): it is gone with the program that
// holds it, however that ends, and nothing is left to be cleaned up.
#pragma once

#include <string>

#include "core/result.h"               // Result
#include "host/files/output_target.h"  // OutputTarget

namespace host {

class NameLock {
 public:
  // An error says that another program writes `path` just now. Where the system has no such
  // sockets there is no lock, and no error. REQUIRES: the target is no stream.
  [[nodiscard]] static core::Result<NameLock> take(const OutputTarget& target,
                                                   const std::string& path);

  NameLock() = default;
  ~NameLock();
  NameLock(NameLock&& other) noexcept;
  NameLock& operator=(NameLock&& other) noexcept;

 private:
  explicit NameLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace host
