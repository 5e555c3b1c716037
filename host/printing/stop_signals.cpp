#include "host/printing/stop_signals.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>

#include "host/exit_codes.h"

namespace host {
namespace {

std::atomic<int> g_count = 0;
std::atomic<int> g_pauses = 0;
std::atomic<bool> g_at_stake = false;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not wait for a lock");
static_assert(std::atomic<bool>::is_always_lock_free);

void count_signal(int) {
  if (g_count.fetch_add(1) > 0 && !g_at_stake.load()) _exit(kExitStopped);
}

void count_pause(int) { g_pauses.fetch_add(1); }

}  // namespace

void watch_stop_signals() {
  struct sigaction action {};
  action.sa_handler = count_signal;
  sigemptyset(&action.sa_mask);
  // Reads and writes of files go on; the link's waits are short by themselves.
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // Whoever started us with a signal ignored (nohup) meant it.
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
  action.sa_handler = count_pause;
  sigaction(SIGUSR1, &action, nullptr);
  action.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &action, nullptr);
  sigaction(SIGXFSZ, &action, nullptr);
}

int stop_signal_count() { return g_count.load(); }

int pause_signal_count() { return g_pauses.load(); }

void set_at_stake(bool at_stake) { g_at_stake.store(at_stake); }

}  // namespace host
