#include "components/planner/pages.h"

#include <sys/mman.h>

#include <algorithm>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <mutex>
#include <system_error>
#include <thread>

namespace goalnet::planner {
namespace {

constexpr std::size_t kMostWaiting = 256u << 20;  // [bytes]

// Ranges to give back, and the thread that does it. One for the process, made when first needed and never
// destroyed, as the thread runs until the process ends.
class Returns {
 public:
  static Returns& instance() {
    static auto& returns = *new Returns;
    return returns;
  }
  void add(void* pages, std::size_t bytes) {
    if (!running_) return give_back(new (pages) Range{nullptr, bytes});
    {
      const std::lock_guard lock(mutex_);
      first_ = new (pages) Range{first_, bytes};
      waiting_ += bytes;
    }
    added_.notify_one();
  }
  // So that a thread that frees and takes faster than ours gives back does not use up the memory.
  void help() {
    Range* range = nullptr;
    {
      const std::lock_guard lock(mutex_);
      if (waiting_ > kMostWaiting) range = take();
    }
    if (range != nullptr) give_back(range);
  }

 private:
  struct Range {  // lies in what is given back
    Range* next;
    std::size_t bytes;
  };

  Returns() {
    sigset_t all, before;  // signals are for the program's own threads
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    try {
      std::thread([this] { run(); }).detach();
      running_ = true;
    } catch (const std::system_error&) {  // no more threads: then it is done at once
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
  [[noreturn]] void run() {
    for (;;) {
      std::unique_lock lock(mutex_);
      added_.wait(lock, [this] { return first_ != nullptr; });
      Range* const range = take();
      lock.unlock();
      give_back(range);
    }
  }
  Range* take() {
    Range* const range = first_;
    first_ = range->next;
    waiting_ -= range->bytes;
    return range;
  }
  // In small parts: others cannot ask the system for memory meanwhile.
  static void give_back(Range* range) {
    constexpr std::size_t kPart = 1u << 20;
    auto* const start = reinterpret_cast<std::byte*>(range);
    const std::size_t bytes = range->bytes;
    for (std::size_t done = 0; done < bytes; done += kPart)
      madvise(start + done, std::min(kPart, bytes - done), MADV_DONTNEED);
    munmap(start, bytes);
  }

  std::mutex mutex_;
  std::condition_variable added_;
  Range* first_ = nullptr;
  std::size_t waiting_ = 0;
  bool running_ = false;
};

// A range of addresses, aligned to kUnit.
std::byte* reserve(std::size_t bytes, int protection) {
  void* const raw = mmap(nullptr, bytes + Pages::kUnit, protection, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (raw == MAP_FAILED) return nullptr;
  auto* const start = static_cast<std::byte*>(raw);
  const std::size_t before =
      (Pages::kUnit - reinterpret_cast<std::uintptr_t>(start) % Pages::kUnit) % Pages::kUnit;
  if (before > 0) munmap(start, before);
  if (before < Pages::kUnit) munmap(start + before + bytes, Pages::kUnit - before);
  return start + before;
}

}  // namespace

void* Pages::map(std::size_t bytes) {
  Returns::instance().help();
  std::byte* const start = reserve(bytes, PROT_READ | PROT_WRITE);
  if (start != nullptr) madvise(start, bytes, MADV_NOHUGEPAGE);
  return start;
}

void* Pages::move(void* pages, std::size_t before, std::size_t bytes) {
  std::byte* const start = reserve(bytes, PROT_NONE);
  if (start == nullptr) return nullptr;
  void* const moved = mremap(pages, before, bytes, MREMAP_MAYMOVE | MREMAP_FIXED, start);
  if (moved != MAP_FAILED) return moved;
  munmap(start, bytes);
  return nullptr;
}

void Pages::unmap(void* pages, std::size_t bytes) { Returns::instance().add(pages, bytes); }

}  // namespace goalnet::planner
