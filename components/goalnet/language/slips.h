// Slips of the tongue that are mended in mid-speech: "the fork, hmm, spoon", "burner two, sorry, burner
// four".
#pragma once

#include <string>
#include <vector>

namespace goalnet::inference {

class Language;

// Puts "correction" for the interjection in front of a bare thing, place or number that ends its part and
// follows one that was named before: "the fork , hmm , spoon" -> "the fork , correction spoon"; "the beer ,
// oh no , not the beer , the coke" -> "the beer , correction not the beer , the coke"; "two books , actually
// all three" -> "two books , correction all".
void mark_slips(std::vector<std::string>& words, const Language& language);

}  // namespace goalnet::inference
