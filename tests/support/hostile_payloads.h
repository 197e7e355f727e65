// Bytes that nobody should send, for any type of idl/: for reading code that must survive them.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "idl/type_description.h"

namespace goalnet::testing_support {

using Bytes = std::vector<std::uint8_t>;

// What a well-formed message is filled with.
struct Filling {
  std::uint64_t number = 0;    // integers, cut to their size
  double real = 0;             // floats
  std::string text = {};       // strings, cut to their bound
  std::uint32_t elements = 1;  // of each sequence, cut to its bound
};

// A well-formed payload (4 bytes of encapsulation, plain CDR, little endian) of that type.
Bytes filled_payload(const idl::TypeDescription& type, const Filling& filling);

// Payloads that are no message of the type: too short, cut off, of another encoding, with lengths beyond
// their end, with texts that are not UTF-8, random.
std::vector<Bytes> malformed_payloads(const idl::TypeDescription& type, std::mt19937& random);

// Well-formed payloads with contents that make no sense: NaN, infinities, largest numbers, long and strange
// texts, empty and long sequences.
std::vector<Bytes> senseless_payloads(const idl::TypeDescription& type);

}  // namespace goalnet::testing_support
