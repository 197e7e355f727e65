// What tells whether a message asks for a request: the words around what it names, and what each of them is.
#pragma once

#include <cstdint>
#include <vector>

#include "components/goalnet/gist/request.h"

namespace goalnet::inference::gist {

inline constexpr std::size_t kFeatures = 1u << 18;  // hashed

// Numbers below kFeatures.
std::vector<std::uint32_t> features(const Message& message, const Request& request);

}  // namespace goalnet::inference::gist
