// Objects, options and words are numbered with int, so that -1 can say "none"; containers want std::size_t.
#pragma once

#include <cstddef>

namespace goalnet::inference {

inline std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace goalnet::inference
