// How many elements have to be left out, inserted or exchanged to turn one list into another (Levenshtein).
#pragma once

#include <cstdint>
#include <span>

namespace goalnet::inference {

std::size_t edit_distance(std::span<const std::uint32_t> left, std::span<const std::uint32_t> right);

}  // namespace goalnet::inference
