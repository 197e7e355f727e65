#include "tests/unit/goalnet_network/heap_count.h"

#include <atomic>
#include <cstddef>

namespace {
std::atomic<std::uint64_t> calls{0};
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* malloc(std::size_t size) {
  calls.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}
#endif

namespace goalnet::inference::test {

std::uint64_t heap_calls() { return calls.load(); }

bool counts_heap_calls() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  return true;
#else
  return false;
#endif
}

}  // namespace goalnet::inference::test
