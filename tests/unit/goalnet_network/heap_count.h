// Counts calls of malloc in this test program.
#pragma once

#include <cstdint>

namespace goalnet::inference::test {

std::uint64_t heap_calls();
// False under a sanitizer, which replaces malloc itself.
bool counts_heap_calls();

}  // namespace goalnet::inference::test
