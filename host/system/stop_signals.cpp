#include "host/system/stop_signals.h"

#include <poll.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>

#include "host/system/exit_codes.h"
#include "host/system/unfinished_files.h"

namespace host {
namespace {

std::atomic<int> g_count = 0;
std::atomic<int> g_interrupts = 0;
std::atomic<int> g_pauses = 0;
std::atomic<bool> g_at_stake = false;
std::atomic<int> g_shields = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not wait for a lock");
static_assert(std::atomic<bool>::is_always_lock_free);

timer_t g_timer;
std::atomic<bool> g_has_timer = false;
std::atomic<bool> g_timer_runs = false;

// Two of each, so that the handler never reads one that is being changed.
struct Words {
  std::array<char, kLastWordsMax> bytes{};
  std::size_t size = 0;
};
struct BothWords {
  Words standard_output, standard_error;
};
std::array<BothWords, 2> g_words;
std::atomic<int> g_current_words = 0;

void set_timer(long milliseconds) {
  itimerspec when{};
  when.it_value.tv_nsec = milliseconds * 1'000'000;
  (void)::timer_settime(g_timer, 0, &when, nullptr);
}

// Writes only if the reader is ready: a stalled one must not block the end.
void say(int descriptor, const Words& words) {
  pollfd ready{descriptor, POLLOUT, 0};
  if (words.size == 0 || ::poll(&ready, 1, 0) != 1 || (ready.revents & POLLOUT) == 0) return;
  (void)!::write(descriptor, words.bytes.data(), words.size);
}

// Runs in the handler: async-signal-safe calls only.
void end_program() {
  if (g_at_stake.load()) return g_timer_runs.store(false);
  if (g_shields.load() > 0 && g_has_timer.load()) return set_timer(10);
  const BothWords& words = g_words[static_cast<std::size_t>(g_current_words.load())];
  remove_unfinished_files();
  say(STDOUT_FILENO, words.standard_output);
  say(STDERR_FILENO, words.standard_error);
  _exit(kExitStopped);
}

void count_stop(int signal) {
  const int before = errno;
  g_count.fetch_add(1);
  const bool again = signal == SIGINT && g_interrupts.fetch_add(1) > 0;
  if (!g_at_stake.load()) {
    if (again || !g_has_timer.load()) {
      end_program();
    } else if (!g_timer_runs.exchange(true)) {
      set_timer(kStopGrace_ms);
    }
  }
  errno = before;
}

void count_timer(int) {
  const int before = errno;
  end_program();
  errno = before;
}

void count_pause(int) { g_pauses.fetch_add(1); }

void keep(const std::string& text, Words& words) {
  words.size = std::min(text.size(), words.bytes.size());
  std::copy_n(text.begin(), words.size, words.bytes.begin());
}

}  // namespace

void watch_stop_signals() {
  struct sigaction action {};
  // Handlers don't interrupt one another.
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGALRM}) sigaddset(&action.sa_mask, signal);
  // Reads and writes of files are restarted; the link's waits are short anyway.
  action.sa_flags = SA_RESTART;
  action.sa_handler = count_timer;
  sigaction(SIGALRM, &action, nullptr);
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGALRM;
  g_has_timer.store(::timer_create(CLOCK_MONOTONIC, &event, &g_timer) == 0);
  sigset_t alarm;
  sigemptyset(&alarm);
  sigaddset(&alarm, SIGALRM);
  (void)::pthread_sigmask(SIG_UNBLOCK, &alarm, nullptr);
  action.sa_handler = count_stop;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // A signal that was ignored at the start (nohup) stays ignored.
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
  sigemptyset(&action.sa_mask);
  action.sa_handler = count_pause;
  sigaction(SIGUSR1, &action, nullptr);
  action.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &action, nullptr);
  sigaction(SIGXFSZ, &action, nullptr);
}

int stop_signal_count() { return g_count.load(); }

int stop_urgency() {
  if (g_count.load() == 0) return 0;
  return g_interrupts.load() > 1 ? 2 : 1;
}

int pause_signal_count() { return g_pauses.load(); }

void set_at_stake(bool at_stake) { g_at_stake.store(at_stake); }

void set_last_words(const LastWords& words) {
  const int other = 1 - g_current_words.load();
  BothWords& both = g_words[static_cast<std::size_t>(other)];
  keep(words.standard_output, both.standard_output);
  keep(words.standard_error, both.standard_error);
  g_current_words.store(other);
}

StopShield::StopShield() { g_shields.fetch_add(1); }

StopShield::~StopShield() { g_shields.fetch_sub(1); }

}  // namespace host
