// A lock on a file name: only one program of this computer writes a name at a time.
//
// The lock is an abstract socket name in the kernel, no file. It disappears with the program that
// holds it, however the program ends, so nothing has to be cleaned up.
#pragma once

#include <string>

#include "core/result.h"               // Result
#include "host/files/output_target.h"  // OutputTarget

namespace host {

class NameLock {
 public:
  // Error if another program is writing `path`. A system without abstract sockets gives no lock and
  // no error. REQUIRES: the target is no stream.
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
