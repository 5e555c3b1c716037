#include <algorithm>
#include <thread>

#include "host/settings/options.h"  // threads_by_default, threads_at_work
#include "host/system/limits.h"     // kThreadsDefaultMax

namespace host {
namespace {

// That the program may use; 1 where the system does not tell.
int processors() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace

int threads_by_default() { return std::min(processors(), kThreadsDefaultMax); }

int threads_at_work(int asked) { return std::clamp(asked, 1, processors()); }

}  // namespace host
