// Other sentences for recorded demonstrations: how well a model understands what nobody said while recording.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "components/goalnet/demonstration.h"

namespace goalnet::inference {

using OtherSentences = std::map<std::string, std::string>;  // id of the demonstration -> sentence

// Reads a table: file name of the demonstration, a tab, the new sentence; one a line. Empty lines and lines
// that begin with '#' are passed over. Fails with kInvalidRequest: which line, and what is wrong with it (no
// tab, no *.json, no sentence, a sentence that cannot be read, a file named twice), also for an empty table.
Expected<OtherSentences> read_other_sentences(const std::filesystem::path& path);

// Whether all that the table names is there and may be tested; kInvalidRequest otherwise: what is not.
Expected<void> check_other_sentences(const OtherSentences& sentences,
                                     const std::vector<Demonstration>& demonstrations);

// How many demonstrations that could be tested the table leaves out.
std::size_t count_left_out(const OtherSentences& sentences, const std::vector<Demonstration>& demonstrations);

// The demonstration with its other sentence; everything else stays, the words of its grounding too.
Demonstration with_sentence(Demonstration demonstration, const OtherSentences& sentences);

}  // namespace goalnet::inference
