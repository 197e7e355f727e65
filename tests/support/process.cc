#include "tests/support/process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

namespace goalnet::testing_support {

using Clock = std::chrono::steady_clock;

struct Process::Impl {
  pid_t pid = -1;
  int out_fd = -1;
  int err_fd = -1;
  bool waited = false;
  int status = 0;
  Clock::time_point start = Clock::now();
  mutable std::mutex mutex;
  std::string out, err;
  std::thread out_reader, err_reader;

  void read_all(int fd, std::string& into) {
    char buffer[4096];
    for (ssize_t got = 0; (got = read(fd, buffer, sizeof buffer)) > 0;) {
      const std::lock_guard lock(mutex);
      into.append(buffer, static_cast<std::size_t>(got));
    }
    close(fd);
  }
};

Process::Process(const std::vector<std::string>& arguments,
                 const std::map<std::string, std::string>& environment)
    : impl_(new Impl) {
  int out_pipe[2], err_pipe[2];
  if (pipe2(out_pipe, O_CLOEXEC) != 0 || pipe2(err_pipe, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  impl_->pid = fork();
  if (impl_->pid == 0) {
    dup2(out_pipe[1], STDOUT_FILENO);
    dup2(err_pipe[1], STDERR_FILENO);
    for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
    execv(argv[0], argv.data());
    _exit(127);
  }
  close(out_pipe[1]);
  close(err_pipe[1]);
  impl_->out_reader = std::thread([this, fd = out_pipe[0]] { impl_->read_all(fd, impl_->out); });
  impl_->err_reader = std::thread([this, fd = err_pipe[0]] { impl_->read_all(fd, impl_->err); });
}

Process::~Process() {
  if (!impl_->waited) wait(std::chrono::milliseconds(0));
  delete impl_;
}

void Process::signal(int number) { kill(impl_->pid, number); }

int Process::pid() const { return impl_->pid; }

bool Process::ended() const {
  siginfo_t info{};
  return impl_->waited ||
         (waitid(P_PID, static_cast<id_t>(impl_->pid), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
          info.si_pid == impl_->pid);
}

std::string Process::out() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->out;
}

std::string Process::err() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->err;
}

bool Process::wait_for_text(const std::string& text, std::chrono::milliseconds limit) const {
  const auto end = Clock::now() + limit;
  while (out().find(text) == std::string::npos && err().find(text) == std::string::npos) {
    if (Clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

ProcessResult Process::wait(std::chrono::milliseconds limit) {
  bool killed = false;
  while (waitpid(impl_->pid, &impl_->status, WNOHANG) == 0) {
    if (!killed && Clock::now() - impl_->start > limit) {
      kill(impl_->pid, SIGKILL);
      killed = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  impl_->waited = true;
  ProcessResult result;
  result.seconds = std::chrono::duration<double>(Clock::now() - impl_->start).count();
  impl_->out_reader.join();
  impl_->err_reader.join();
  result.exit_code = killed                       ? -1
                     : WIFEXITED(impl_->status)   ? WEXITSTATUS(impl_->status)
                     : WIFSIGNALED(impl_->status) ? 128 + WTERMSIG(impl_->status)
                                                  : -1;
  result.out = impl_->out;
  result.err = impl_->err;
  return result;
}

std::string program(const std::string& name) { return std::string(GOALNET_PROGRAM_FOLDER) + "/" + name; }

ProcessResult run_goalnet(const std::vector<std::string>& arguments, int domain,
                          const std::map<std::string, std::string>& environment,
                          std::chrono::milliseconds limit) {
  std::vector<std::string> all = {program("goalnet")};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::map<std::string, std::string> with_domain = environment;
  with_domain.emplace("ROS_DOMAIN_ID", std::to_string(domain));
  return Process(all, with_domain).wait(limit);
}

std::vector<std::string> shared_memory_of(int pid) {
  std::set<std::string> files;
  std::ifstream maps("/proc/" + std::to_string(pid) + "/maps");
  for (std::string line; std::getline(maps, line);) {
    const std::size_t place = line.find("/dev/shm/fast");
    if (place != std::string::npos) files.insert(line.substr(place));
  }
  return {files.begin(), files.end()};
}

std::vector<std::string> shared_memory_of_domain(int domain) {
  // The RTPS specification's mapping: 250 ports a domain, from 7400 on.
  const int first = 7400 + 250 * domain;
  std::vector<std::string> files;
  for (int port = first; port < first + 250; ++port) {
    const std::string file = "/dev/shm/fastrtps_port" + std::to_string(port);
    if (std::filesystem::exists(file)) files.push_back(file);
  }
  return files;
}

}  // namespace goalnet::testing_support
