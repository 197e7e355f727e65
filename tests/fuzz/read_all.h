// What fuzzers of bag files do with one that opened, or did not.
#pragma once

#include <cstdlib>
#include <memory>

#include "components/ros/bag/storage_reader.h"

namespace goalnet::ros {

// Reads to the end or the first error, which must say something. Returns 0.
inline int read_all(const Expected<std::unique_ptr<StorageReader>>& file) {
  if (!file) {
    if (file.error().message.empty()) std::abort();
    return 0;
  }
  BagMessage message;
  for (;;) {
    const auto more = (*file)->next(message);
    if (!more && more.error().message.empty()) std::abort();
    if (!more || !*more) return 0;
    if (message.topic >= (*file)->topics().size()) std::abort();
  }
}

}  // namespace goalnet::ros
