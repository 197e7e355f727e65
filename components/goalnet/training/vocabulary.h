// What a network needs to know before it learns: words and their vectors, classes, senses, and the grammar.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "components/goalnet/network/grammar.h"
#include "components/goalnet/network/lexicon.h"
#include "components/goalnet/network/tensors.h"
#include "components/goalnet/training/episodes.h"

namespace goalnet::inference::training {

using WordVectors = std::map<std::string, std::vector<float>>;

// Reads {"word": [numbers]} files such as conceptnet.json and vocab.json; words in lower case. Earlier files
// win; a missing file is left out. All vectors of one size. Errors: kInvalidRequest with the file.
Expected<WordVectors> read_word_vectors(const std::vector<std::filesystem::path>& files);

struct Vocabulary {
  network::Lexicon lexicon;
  network::Grammar grammar;
  network::Matrix vectors;  // words x size
};

// Words: of the vectors, the sentences and the objects' names. Vectors are reduced to `size` numbers by their
// principal axes. Senses are counted from the groundings; the grammar is what occurs in any episode's states
// and goals, and in constants.json (`constants`, may be missing).
Expected<Vocabulary> make_vocabulary(const std::vector<Episode>& episodes, const WordVectors& vectors,
                                     int size, const std::filesystem::path& constants);

}  // namespace goalnet::inference::training
