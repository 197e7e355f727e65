#include "tools/goalnet/launch/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace goalnet::tools {
namespace {

// A longer line is cut in pieces: a child that never ends its line must not fill our memory.
constexpr std::size_t kLongestLine = 65'536;

// In the child, before it becomes the program. Reports errno through `report` where that fails.
[[noreturn]] void become(const std::vector<char*>& argv,
                         const std::map<std::string, std::string>& environment, pid_t parent, int out,
                         int err, int report) {
  setpgid(0, 0);  // Ctrl-C at the terminal is for the launcher, which ends its children in order
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(127);  // it died before the line above
  for (const int number : {SIGINT, SIGTERM, SIGPIPE, SIGHUP}) ::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  if (const int null = open("/dev/null", O_RDONLY); null >= 0) dup2(null, STDIN_FILENO);
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
  execv(argv[0], argv.data());
  const int why = errno;
  if (write(report, &why, sizeof why) < 0) {
  }  // the exit code says it, too
  _exit(127);
}

}  // namespace

Expected<ChildProcess> ChildProcess::start(const std::vector<std::string>& command,
                                           const std::map<std::string, std::string>& environment) {
  int out[2] = {-1, -1}, err[2] = {-1, -1}, report[2] = {-1, -1};
  const auto close_all = [&] {
    for (const int fd : {out[0], out[1], err[0], err[1], report[0], report[1]}) {
      if (fd >= 0) close(fd);
    }
  };
  const auto refuse = [&](const char* what) {
    const std::string why = std::string(what) + ": " + std::strerror(errno);
    close_all();
    return fail(Outcome::kInternal, command[0] + ": " + why);
  };
  if (pipe2(out, O_CLOEXEC) != 0 || pipe2(err, O_CLOEXEC) != 0 || pipe2(report, O_CLOEXEC) != 0)
    return refuse("no pipe");
  std::vector<char*> argv;
  for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid < 0) return refuse("no process");
  if (pid == 0) become(argv, environment, parent, out[1], err[1], report[1]);
  setpgid(pid, pid);  // on both sides: whoever comes first
  for (int* end : {&out[1], &err[1], &report[1]}) close(std::exchange(*end, -1));
  int why = 0;
  ssize_t got = 0;
  do {
    got = read(report[0], &why, sizeof why);  // ends when the program runs
  } while (got < 0 && errno == EINTR);
  if (got == sizeof why) {
    waitpid(pid, nullptr, 0);
    errno = why;
    return refuse("cannot be started");
  }
  close(report[0]);
  ChildProcess child;
  child.pid_ = pid;
  child.pipes_[0].fd = out[0];
  child.pipes_[1].fd = err[0];
  for (const Pipe& pipe : child.pipes_) fcntl(pipe.fd, F_SETFL, O_NONBLOCK);
  return child;
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept { *this = std::move(other); }

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  if (this == &other) return *this;
  drop();
  pid_ = std::exchange(other.pid_, -1);
  status_ = std::exchange(other.status_, std::nullopt);
  for (int i = 0; i < 2; ++i) {
    pipes_[i].fd = std::exchange(other.pipes_[i].fd, -1);
    pipes_[i].partial = std::move(other.pipes_[i].partial);
  }
  return *this;
}

ChildProcess::~ChildProcess() { drop(); }

void ChildProcess::drop() {
  if (pid_ > 0 && !status_) {
    signal(SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  for (Pipe& pipe : pipes_) {
    if (pipe.fd >= 0) close(std::exchange(pipe.fd, -1));
  }
  pid_ = -1;
}

std::optional<int> ChildProcess::exit_code() {
  int status = 0;
  if (!status_ && waitpid(pid_, &status, WNOHANG) == pid_)
    status_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return status_;
}

void ChildProcess::signal(int number) const {
  if (pid_ > 0 && !status_) kill(-pid_, number);
}

void ChildProcess::read_lines(const LineSink& sink, bool rest) {
  for (int i = 0; i < 2; ++i) {
    Pipe& pipe = pipes_[i];
    char buffer[8192];
    while (pipe.fd >= 0) {
      const ssize_t got = read(pipe.fd, buffer, sizeof buffer);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) break;  // nothing now
      if (got == 0) {
        close(std::exchange(pipe.fd, -1));
        break;
      }
      pipe.partial.append(buffer, static_cast<std::size_t>(got));
      std::size_t start = 0;
      for (std::size_t end; (end = pipe.partial.find('\n', start)) != std::string::npos; start = end + 1)
        sink(pipe.partial.substr(start, end - start), i == 1);
      pipe.partial.erase(0, start);
      if (pipe.partial.size() > kLongestLine) sink(std::exchange(pipe.partial, {}), i == 1);
    }
    if (rest && !pipe.partial.empty()) sink(std::exchange(pipe.partial, {}), i == 1);
  }
}

}  // namespace goalnet::tools
