// A child of the launcher: started in a process group of its own, its output read line by line.
#pragma once

#include <sys/types.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "components/core/outcome.h"

namespace goalnet::tools {

// One thread. A child does not outlive the thread that started it: the kernel sends it SIGTERM then.
class ChildProcess {
 public:
  // Errors: kInternal where the system refuses to start one, or the program cannot be executed.
  static Expected<ChildProcess> start(const std::vector<std::string>& command,
                                      const std::map<std::string, std::string>& environment);
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;
  ~ChildProcess();  // kills it if it still runs

  pid_t pid() const { return pid_; }
  bool running() const { return !status_; }

  // Its end, if it has come: the exit code, or 128 + the signal.
  std::optional<int> exit_code();

  // To the child and all that it started.
  void signal(int number) const;

  // File descriptors to poll; -1 once they are at their end.
  int out() const { return pipes_[0].fd; }
  int err() const { return pipes_[1].fd; }

  // Hands on the lines that can be read now, without line ends; never blocks. `rest`: also one without an
  // end.
  using LineSink = std::function<void(const std::string& line, bool error)>;
  void read_lines(const LineSink& sink, bool rest);

 private:
  ChildProcess() = default;
  struct Pipe {
    int fd = -1;
    std::string partial;  // bounded
  };
  void drop();

  pid_t pid_ = -1;
  std::optional<int> status_;
  Pipe pipes_[2];  // standard output, standard error
};

}  // namespace goalnet::tools
