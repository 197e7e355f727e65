// A DDS domain for a test program alone, whatever other tests of this user run meanwhile.
#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <stdexcept>
#include <string>

namespace goalnet::testing_support {

// One for the whole process, taken at the first call and given back by its end. Below 102: from there on
// the ports of a domain lie among those that the kernel hands out to everybody (from 32768 on), and whoever
// happens to have one keeps a participant from starting. 71 to 101 are for tests that name their domain.
inline int own_domain() {
  static const int domain = [] {
    constexpr int kFirst = 10, kCount = 60;
    for (int i = 0; i < kCount; ++i) {
      const int one = kFirst + (static_cast<int>(getpid()) + i) % kCount;
      const std::string path =
          "/tmp/goalnet_test_domain_" + std::to_string(getuid()) + "_" + std::to_string(one);
      // Never closed: the lock lasts as long as the process.
      const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
      if (file < 0) continue;
      if (flock(file, LOCK_EX | LOCK_NB) == 0) return one;
      close(file);
    }
    throw std::runtime_error("no free DDS domain: sixty tests at once, or /tmp is not writable");
  }();
  return domain;
}

}  // namespace goalnet::testing_support
