#include "components/planner/arena.h"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace goalnet::planner {
namespace {

constexpr std::size_t kFirstBlock = 2u << 10;        // [bytes]; every further block is twice as large
constexpr std::size_t kLargestBlock = Pages::kHuge;  // but for single larger requests

// A range of addresses, aligned to huge pages.
std::byte* reserve(std::size_t bytes, int protection) {
  void* const raw = mmap(nullptr, bytes + Pages::kHuge, protection, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (raw == MAP_FAILED) return nullptr;
  auto* const start = static_cast<std::byte*>(raw);
  const std::size_t before =
      (Pages::kHuge - reinterpret_cast<std::uintptr_t>(start) % Pages::kHuge) % Pages::kHuge;
  if (before > 0) munmap(start, before);
  if (before < Pages::kHuge) munmap(start + before + bytes, Pages::kHuge - before);
  return start + before;
}

}  // namespace

void* Pages::map(std::size_t bytes) {
  std::byte* const start = reserve(bytes, PROT_READ | PROT_WRITE);
  if (start != nullptr) madvise(start, bytes, MADV_HUGEPAGE);  // where that fails, small pages serve, too
  return start;
}

// Both ranges are aligned, so that the system moves page tables, or huge pages, whole.
void* Pages::move(void* pages, std::size_t before, std::size_t bytes) {
  std::byte* const start = reserve(bytes, PROT_NONE);
  if (start == nullptr) return nullptr;
  void* const moved = mremap(pages, before, bytes, MREMAP_MAYMOVE | MREMAP_FIXED, start);
  if (moved != MAP_FAILED) return moved;
  munmap(start, bytes);
  return nullptr;
}

void Pages::unmap(void* pages, std::size_t bytes) { munmap(pages, bytes); }

void* Arena::more(std::size_t bytes, std::size_t alignment) {
  const std::size_t last = blocks_.empty() ? kFirstBlock / 2 : blocks_.back().bytes;
  std::size_t size = std::max(std::min(2 * last, kLargestBlock), bytes + alignment);
  Block block{nullptr, size, size > Pages::kHeapMost};
  blocks_.reserve(blocks_.size() + 1);
  if (block.mapped) {
    block.bytes = Pages::whole(size);
    block.memory = static_cast<std::byte*>(Pages::map(block.bytes));
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
      Pages::unmap(block.memory, block.bytes);
    } else {
      std::free(block.memory);
    }
  }
}

}  // namespace goalnet::planner
