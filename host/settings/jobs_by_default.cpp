#include <algorithm>
#include <thread>

#include "host/settings/options.h"  // jobs_by_default
#include "host/system/limits.h"     // kJobsDefaultMax

namespace host {

int jobs_by_default() {
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kJobsDefaultMax);
}

}  // namespace host
