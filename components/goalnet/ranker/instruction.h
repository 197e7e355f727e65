// An instruction seen against the objects of a world: which words name which things, and how well.
#pragma once

#include <string>
#include <vector>

#include "components/goalnet/goal_model.h"
#include "components/goalnet/language/language.h"
#include "components/goalnet/lexicon.h"
#include "components/goalnet/sym_state.h"

namespace goalnet::inference {

// A stretch of words that names something.
struct Mention {
  int begin = 0, end = 0;  // words [begin, end)
  std::string phrase;      // normal form
  bool plural = false;
};

// One object of the world, in the light of the instruction.
struct SeenObject {
  Symbol symbol = symbol::kNone;
  std::uint32_t name_hash = 0;  // the same in every process, as symbols are not
  ClassId class_id = 0;
  std::uint8_t rank = 0;      // number among the world's objects of its class, in the order of their names
  std::uint8_t of_class = 1;  // how many there are
  NameLevel level = NameLevel::kNone;
  bool grounded = false;          // named by the given grounding
  int mention = -1;               // index of the best mention
  int rivals = 0;                 // objects that the same mention names as well as this one, itself included
  std::uint32_t word_before = 0;  // of the mention: "on", "from", ...
  std::uint32_t clause = 0;       // the frame of the verb that the mention stands behind; see Language::verb
};

struct Instruction {
  std::vector<std::string> words;                // singular, without articles; "." between sentences
  std::vector<std::uint32_t> unigrams, bigrams;  // hashes of words and frames (unique), neighbouring pairs
  std::uint32_t first_verb = 0;                  // the first word that is no filler
  std::uint32_t first_frame = 0;                 // of the first word that is a verb; 0: there is none
  std::vector<Mention> mentions;                 // in order
  std::vector<SeenObject> objects;               // in the order of their names; Robot left out
  std::vector<std::int16_t> index;               // of each symbol in objects; -1: not in this world
  bool grounding_given = false;

  // Index into objects, or -1.
  int find(Symbol symbol) const {
    return symbol != symbol::kNone && symbol < index.size() ? index[symbol] : -1;
  }
};

// `words` as tokenize() gives them; `objects`: names of the world's objects. What verbs of one frame have in
// common ("take", "grab") stands among the unigrams and bigrams like a word, so that a verb never seen in
// training still says something.
Instruction see_instruction(const std::vector<std::string>& words, const Grounding* grounding,
                            const std::vector<std::string>& objects, Lexicon& lexicon,
                            const Language& language, Symbols& symbols);

std::uint32_t hash_text(std::string_view text);

}  // namespace goalnet::inference
