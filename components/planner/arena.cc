#include "components/planner/arena.h"

#include <cstdlib>
#include <new>

namespace goalnet::planner {
namespace {

constexpr std::size_t kFirstBlock = 2u << 10;        // [bytes]; every further block is twice as large
constexpr std::size_t kLargestBlock = Pages::kUnit;  // but for single larger requests

}  // namespace

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
