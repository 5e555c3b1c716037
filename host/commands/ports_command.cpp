#include "host/commands/commands.h"
#include "host/exit_codes.h"

namespace host {

// Both wait for the link's ports.
int print_command(const Options&, Reporter& reporter) {
  reporter.error("printing is not built in yet", kExitUsage);
  return kExitUsage;
}

int ports_command(const Options&, Reporter& reporter) {
  reporter.error("ports are not built in yet", kExitUsage);
  return kExitUsage;
}

}  // namespace host
