#include "tools/goalnet/stop_signal.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <thread>

#include "components/core/outcome.h"

namespace goalnet::tools {
namespace {

// What the handler may touch: a pipe to the thread that does the rest.
std::atomic<int> signal_pipe{-1};
std::atomic<int> signal_count{0};

void handle(int number) {
  const int saved = errno;
  // A terminal that is closed says so more than once: that is not impatience.
  if (number == SIGHUP && signal_count.load() > 0) return;
  if (signal_count.fetch_add(1) >= 1) _exit(static_cast<int>(Outcome::kCancelled));
  const char byte = 's';
  if (const int fd = signal_pipe.load(); fd >= 0) {
    if (write(fd, &byte, 1) < 0) {
    }  // nothing a handler could do about it
  }
  errno = saved;
}

}  // namespace

struct StopSignal::Impl {
  std::function<void()> on_signal;
  int read_end = -1;
  int write_end = -1;
  struct sigaction old_int {
  }, old_term{}, old_hangup{};
  std::atomic<std::int64_t> first{0};  // steady clock, 0: none
  std::thread thread;

  void wait() {
    char byte = 0;
    ssize_t got = 0;
    do {
      got = read(read_end, &byte, 1);
    } while (got < 0 && errno == EINTR);
    if (got != 1 || byte != 's') return;
    first.store(std::chrono::steady_clock::now().time_since_epoch().count());
    if (on_signal) on_signal();
  }
};

StopSignal::StopSignal(std::function<void()> on_signal) : impl_(new Impl) {
  impl_->on_signal = std::move(on_signal);
  int ends[2] = {-1, -1};
  if (pipe(ends) == 0) {
    impl_->read_end = ends[0];
    impl_->write_end = ends[1];
    impl_->thread = std::thread([impl = impl_] { impl->wait(); });
  }
  signal_count = 0;
  signal_pipe = impl_->write_end;
  struct sigaction action {};
  action.sa_handler = handle;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &impl_->old_int);
  sigaction(SIGTERM, &action, &impl_->old_term);
  sigaction(SIGHUP, &action, &impl_->old_hangup);
  if (impl_->old_hangup.sa_handler == SIG_IGN)  // nohup
    sigaction(SIGHUP, &impl_->old_hangup, nullptr);
}

StopSignal::~StopSignal() {
  sigaction(SIGINT, &impl_->old_int, nullptr);
  sigaction(SIGTERM, &impl_->old_term, nullptr);
  sigaction(SIGHUP, &impl_->old_hangup, nullptr);
  signal_pipe = -1;
  if (impl_->thread.joinable()) {
    const char byte = 'q';
    if (write(impl_->write_end, &byte, 1) == 1) impl_->thread.join();
    close(impl_->read_end);
    close(impl_->write_end);
  }
  delete impl_;
}

bool StopSignal::requested() const { return impl_->first.load() != 0; }

std::chrono::steady_clock::duration StopSignal::age() const {
  const std::int64_t first = impl_->first.load();
  if (first == 0) return {};
  return std::chrono::steady_clock::now().time_since_epoch() - std::chrono::steady_clock::duration(first);
}

}  // namespace goalnet::tools
