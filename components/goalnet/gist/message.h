// A message as the gist reader sees it: its words, what kind of word each is, and what they name here.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "components/goalnet/language/language.h"
#include "components/goalnet/lexicon.h"
#include "components/goalnet/ranker/instruction.h"

namespace goalnet::inference::gist {

// Words [begin, end) that name something.
struct Named {
  std::size_t begin = 0, end = 0;
  std::vector<ClassId> classes;    // of things here that the words may mean; several for "cup"
  Symbol content = symbol::kNone;  // what a vessel may hold: "water"
};

struct Message {
  std::vector<std::string> spoken;  // as it was given
  std::vector<std::string> words;   // base forms of those: "put", "plate"
  // What each word is, where the word itself may never have been learned: "verb take", "action" (a verb that
  // no robot knows), "place", "thing", "kind drink", "strange" (no word known here).
  std::vector<std::string> sorts;
  std::vector<Named> named;  // in the order of the message
};

// `tokens`: as tokenize() or normal_words() gives them; `here`: the objects of the world (see_instruction()).
Message see_message(const std::vector<std::string>& tokens, const Instruction& here, const Lexicon& lexicon,
                    const Language& language);

// "first", "two", "3" -> 1 to 6; 0 where the word is no such number.
int small_number(const std::string& word);

}  // namespace goalnet::inference::gist
