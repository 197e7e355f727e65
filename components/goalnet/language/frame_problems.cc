// What is told when a thing is not here or is nothing to do that with.
#include <algorithm>

#include "components/goalnet/language/frame_context.h"

namespace goalnet::inference {

using namespace symbol;

namespace {

constexpr int kMostExamples = 5;

}  // namespace

std::string FrameContext::unknown_thing(const NounPhrase& phrase, Sort sort) const {
  if (phrase.pronoun)
    return "it is not clear what \"" + (phrase.word.empty() ? "it" : phrase.word) + "\" means here";
  if (phrase.unknown) return unknown_name(phrase.word);
  if (phrase.bare()) return "it is not clear what is meant";
  const std::string said = phrase.word.empty() ? phrase.phrase : phrase.word;
  if (const int number = phrase.number > 0 ? phrase.number : phrase.ordinal; at_home_ && number > 0) {
    int highest = 0;
    std::string there_are;
    for (const Symbol object : resolver_.named(phrase)) {
      if (number_of(resolver_.name(object)) == 0) continue;
      highest = std::max(highest, number_of(resolver_.name(object)));
      there_are += (there_are.empty() ? "" : ", ") + resolver_.name(object);
    }
    if (highest > 0 && number > highest) {
      no_such_number_ = true;
      return not_here("there is no " + said + " " + std::to_string(number) + " here; there " +
                      (highest == 1 ? "is only " : "are ") + there_are);
    }
  }
  if (!resolver_.named(phrase).empty()) {
    const std::string name = resolver_.name(resolver_.named(phrase).front());
    switch (sort) {
      case Sort::kMovable:
        return now_.has(Relation::kIsGraspable, resolver_.named(phrase).front())
                   ? "no " + said + " here is as the sentence says; there is " + name
                   : name + " cannot be picked up";
      case Sort::kPlace:
        return "nothing can be put on or into " + name;
      case Sort::kDevice:
        return name + " cannot be turned on or off";
      case Sort::kVessel:
        return name + " is nothing that one could fill or pour from";
      case Sort::kAny:
        break;
    }
    return "no " + said + " here is as the sentence says; there is " + name;
  }
  std::string examples;
  int count = 0;
  for (const Symbol object : resolver_.all(sort, now_))
    if (count++ < 3) examples += (examples.empty() ? "" : ", ") + resolver_.name(object);
  return not_here("there is no " + said + " here" +
                  (examples.empty() ? "" : "; there are, for example, " + examples));
}

std::string FrameContext::not_here(Problem problem) const {
  missing_ = problem;
  return problem;
}

// A name that no thing of any world has. Of an English word it is known what kind of thing that would be:
// milk is a drink, so the drinks that are here are told; of others the nearest in spelling.
std::string FrameContext::unknown_name(const std::string& word) const {
  if (word.empty()) return "it is not clear what is meant";  // "put the"
  const std::string kind = language_.kind_of(word);
  if (kind.empty()) return not_here(language_.unknown_word(word));
  std::string examples;
  int count = 0;
  for (const SeenObject& object : resolver_.objects()) {
    const ObjectClass* c = resolver_.class_of(object.symbol);
    if (c == nullptr || !c->is(kind) || count++ >= kMostExamples) continue;
    examples += (examples.empty() ? "" : ", ") + resolver_.name(object.symbol);
  }
  return not_here("there is no " + word + " here" +
                  (examples.empty() ? ", nor any other " + kind
                                    : "; of the same kind (" + kind + ") there are " + examples));
}

}  // namespace goalnet::inference
