#include "components/planner/arena.h"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace goalnet::planner {
namespace {

constexpr std::size_t kFirstBlock = 2u << 10;  // [bytes]; every further block is twice as large
constexpr std::size_t kHugePage = 2u << 20;    // [bytes]; the largest block but for single larger requests

// A multiple of huge pages, aligned to them; null where the system has no more.
std::byte* map_huge(std::size_t bytes) {
  void* const raw =
      mmap(nullptr, bytes + kHugePage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (raw == MAP_FAILED) return nullptr;
  auto* const start = static_cast<std::byte*>(raw);
  const std::size_t before = (kHugePage - reinterpret_cast<std::uintptr_t>(start) % kHugePage) % kHugePage;
  if (before > 0) munmap(start, before);
  if (before < kHugePage) munmap(start + before + bytes, kHugePage - before);
  madvise(start + before, bytes, MADV_HUGEPAGE);  // where that fails, small pages serve, too
  return start + before;
}

}  // namespace

void* Arena::more(std::size_t bytes, std::size_t alignment) {
  const std::size_t last = blocks_.empty() ? kFirstBlock / 2 : blocks_.back().bytes;
  std::size_t size = std::max(std::min(2 * last, kHugePage), bytes + alignment);
  Block block{nullptr, size, size > kHugePage / 2};
  blocks_.reserve(blocks_.size() + 1);
  if (block.mapped) {
    block.bytes = (size + kHugePage - 1) / kHugePage * kHugePage;
    block.memory = map_huge(block.bytes);
  } else {
    block.memory = static_cast<std::byte*>(std::malloc(block.bytes));
  }
  if (block.memory == nullptr) throw std::bad_alloc();
  blocks_.push_back(block);
  next_ = block.memory;
  end_ = next_ + block.bytes;
  return allocate(bytes, alignment);
}

void Arena::release(std::size_t keep) {
  for (; blocks_.size() > keep; blocks_.pop_back()) {
    const Block& block = blocks_.back();
    if (block.mapped) {
      munmap(block.memory, block.bytes);
    } else {
      std::free(block.memory);
    }
  }
}

}  // namespace goalnet::planner
