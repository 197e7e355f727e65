// Runs the programs of this build as people do, and looks at what they leave behind.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace goalnet::testing_support {

struct ProcessResult {
  int exit_code = -1;  // 128 + signal where a signal ended it
  std::string out;
  std::string err;
  double seconds = 0.0;  // wall clock
};

// A child process. Its output is collected by threads of ours, so that it never blocks on a full pipe.
class Process {
 public:
  // arguments[0] is the program's path. `environment` is added to ours.
  Process(const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment);
  ~Process();  // kills it if it still runs
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void signal(int number);
  int pid() const;
  bool ended() const;
  // Everything printed so far on standard output.
  std::string out() const;
  std::string err() const;
  // Waits until standard output or error holds `text`; false after `limit`.
  bool wait_for_text(const std::string& text, std::chrono::milliseconds limit) const;
  // Waits for the end; kills it after `limit`, exit code -1 then.
  ProcessResult wait(std::chrono::milliseconds limit);

 private:
  struct Impl;
  Impl* impl_;
};

// The built `goalnet` with these arguments, to its end. Each test program has a domain of its own.
ProcessResult run_goalnet(const std::vector<std::string>& arguments, int domain,
                          const std::map<std::string, std::string>& environment = {},
                          std::chrono::milliseconds limit = std::chrono::seconds(120));

// Path of a program of this build: "goalnet", "goalnet-robot".
std::string program(const std::string& name);

// Files of Fast DDS in /dev/shm that a process uses now, sorted.
std::vector<std::string> shared_memory_of(int pid);

// Files in /dev/shm for the ports of a DDS domain: there while a participant of that domain lives.
std::vector<std::string> shared_memory_of_domain(int domain);

}  // namespace goalnet::testing_support
