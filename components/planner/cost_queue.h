// A priority queue of small numbers for Dijkstra-like passes: buckets while costs are small, a heap
// otherwise.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "components/planner/growing.h"

namespace goalnet::planner {

class CostQueue {
 public:
  void clear() {
    for (std::size_t i = current_; i < used_; ++i) buckets_[i].clear();
    current_ = used_ = 0;
    heap_.clear();
    size_ = 0;
  }
  bool empty() const { return size_ == 0; }

  // Costs may go below the last one popped; that is rare and handled.
  void push(std::int64_t cost, std::int32_t item) {
    ++size_;
    if (cost >= kBuckets) {
      heap_.emplace_back(-cost, item);
      std::push_heap(heap_.begin(), heap_.end());
      return;
    }
    const auto bucket = static_cast<std::size_t>(cost);
    if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
    buckets_[bucket].push_back(item);
    used_ = std::max(used_, bucket + 1);
    current_ = std::min(current_, bucket);
  }

  std::pair<std::int64_t, std::int32_t> pop() {
    --size_;
    while (current_ < used_ && buckets_[current_].empty()) ++current_;
    if (current_ < used_) {
      const std::int32_t item = buckets_[current_].back();
      buckets_[current_].truncate(buckets_[current_].size() - 1);
      return {static_cast<std::int64_t>(current_), item};
    }
    std::pop_heap(heap_.begin(), heap_.end());
    const auto [cost, item] = heap_.back();
    heap_.pop_back();
    return {-cost, item};
  }

 private:
  static constexpr std::int64_t kBuckets = 1024;
  std::vector<Growing<std::int32_t>> buckets_;
  std::vector<std::pair<std::int64_t, std::int32_t>> heap_;  // (-cost, item): a max-heap
  std::size_t current_ = 0, used_ = 0, size_ = 0;
};

}  // namespace goalnet::planner
