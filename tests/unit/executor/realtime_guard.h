// Catches what a real-time function must not do. The definitions in realtime_guard.cc replace malloc, the
// pthread locks and output of this test program.
#pragma once

#include <functional>
#include <string>

namespace goalnet::executor::test {

// Runs `function` in the calling thread. Returns the first forbidden call it made (heap, lock, wait, clock,
// output), or "".
std::string first_forbidden_call(const std::function<void()>& function);

// Runs `function` in a child process to which the kernel permits no system call at all.
// Returns true if it came through.
bool runs_without_system_calls(const std::function<void()>& function);

// With a sanitizer, which brings its own malloc and locks, only the system calls can be watched.
bool watches_heap_and_locks();

}  // namespace goalnet::executor::test
