// What a process and a thread must do before they can be punctual on Linux. Nothing here is called in the
// loop.
#pragma once

#include <optional>
#include <string>

namespace goalnet::executor {

// Whole process, once, before threads start: keeps freed memory instead of returning it to the system (so
// that it need not be faulted in again) and locks all pages. Returns what was not permitted, or nothing.
std::optional<std::string> lock_process_memory();

// Undoes lock_process_memory(), for programs that go on with other things.
void unlock_process_memory();

// Calling thread: touches its stack down to `bytes`, so that no page of it is faulted in later.
void prefault_stack();

// Calling thread: SCHED_FIFO at `priority` (1..99). Returns what was not permitted, or nothing.
std::optional<std::string> use_realtime_scheduling(int priority);

// Calling thread: runs on this CPU only. Returns what went wrong, or nothing.
std::optional<std::string> pin_to_cpu(int cpu);

// Calling thread: the name that ps and top show (cut to 15 characters).
void name_thread(const std::string& name);

}  // namespace goalnet::executor
