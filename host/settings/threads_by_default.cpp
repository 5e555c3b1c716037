#include <algorithm>
#include <thread>

#include "host/settings/options.h"  // threads_by_default
#include "host/system/limits.h"     // kThreadsDefaultMax

namespace host {

int threads_by_default() {
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kThreadsDefaultMax);
}

}  // namespace host
