#include <algorithm>
#include <thread>

#include "host/limits.h"            // kJobsDefaultMax
#include "host/settings/options.h"  // jobs_by_default

namespace host {

int jobs_by_default() {
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kJobsDefaultMax);
}

}  // namespace host
