// Closed groups of English words that the grammar itself knows.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace goalnet::inference {

template <std::size_t N>
bool one_of(const std::string& word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Whether nothing follows at `i` that belongs to what stands before it.
inline bool ends_part(const std::vector<std::string>& words, std::size_t i) {
  return i >= words.size() || words[i] == "." || words[i] == ",";
}

namespace word_group {

using std::string_view_literals::operator""sv;

// Determiners, pronouns, words for people and things.

inline constexpr std::array kArticles = {"the"sv, "a"sv,   "an"sv,  "my"sv,    "your"sv,   "our"sv,
                                         "his"sv, "her"sv, "its"sv, "their"sv, "another"sv};
inline constexpr std::array kPointers = {"this"sv, "that"sv, "these"sv, "those"sv};
inline constexpr std::array kPronouns = {"it"sv, "them"sv, "they"sv};
inline constexpr std::array kPersons = {"me"sv,     "us"sv,       "you"sv,      "him"sv,
                                        "myself"sv, "everyone"sv, "everybody"sv};
inline constexpr std::array kAll = {"all"sv, "every"sv, "each"sv};
inline constexpr std::array kThings = {"everything"sv, "stuff"sv,    "thing"sv,  "anything"sv,
                                       "something"sv,  "whatever"sv, "object"sv, "item"sv};
inline constexpr std::array kMeasures = {
    "bit"sv,    "pinch"sv, "splash"sv, "drop"sv,   "lot"sv,  "little"sv, "piece"sv,
    "dash"sv,   "cube"sv,  "slice"sv,  "dollop"sv, "kind"sv, "plenty"sv, "handful"sv,
    "packet"sv, "tub"sv,   "carton"sv, "squirt"sv, "sip"sv,  "amount"sv, "pair"sv};
// Words for many things at once.
inline constexpr std::array kCollective = {"cutlery"sv,   "silverware"sv, "flatware"sv,  "glassware"sv,
                                           "tableware"sv, "crockery"sv,   "drinkware"sv, "furniture"sv};
inline constexpr std::array kStates = {
    "empty"sv, "full"sv,    "hot"sv,   "cold"sv,      "warm"sv, "open"sv,     "closed"sv,
    "left"sv,  "right"sv,   "other"sv, "nearest"sv,   "near"sv, "farthest"sv, "dirty"sv,
    "clean"sv, "wet"sv,     "dry"sv,   "different"sv, "lit"sv,  "free"sv,     "same"sv,
    "held"sv,  "boiling"sv, "last"sv,  "previous"sv,  "next"sv};
// Adjectives that nothing in a world of facts can tell; kept in mind as such.
inline constexpr std::array kVague = {
    "big"sv,    "small"sv,  "little"sv, "large"sv,  "new"sv,    "old"sv,       "red"sv,      "blue"sv,
    "green"sv,  "white"sv,  "brown"sv,  "black"sv,  "yellow"sv, "pink"sv,      "nice"sv,     "soft"sv,
    "lovely"sv, "entire"sv, "whole"sv,  "single"sv, "own"sv,    "favourite"sv, "favorite"sv, "round"sv,
    "shiny"sv,  "usual"sv,  "long"sv,   "tall"sv,   "only"sv,   "fresh"sv};
// "the cup that is still standing in the sink"
inline constexpr std::array kLying = {
    "lying"sv,     "standing"sv, "sitting"sv, "placed"sv, "kept"sv,    "located"sv, "resting"sv, "left"sv,
    "currently"sv, "still"sv,    "now"sv,     "lie"sv,    "sit"sv,     "stand"sv,   "right"sv,   "is"sv,
    "are"sv,       "was"sv,      "were"sv,    "all"sv,    "already"sv, "laying"sv};

// Furniture of which no single kind here has the name.
inline constexpr std::array kFurniture = {"table"sv, "seat"sv, "place"sv, "spot"sv, "surface"sv};

// What sentences that only tell something begin with.
inline constexpr std::array kSubjects = {
    "i"sv,       "we"sv,    "he"sv,     "she"sv,      "they"sv,    "it"sv,       "this"sv,
    "that"sv,    "there"sv, "nobody"sv, "somebody"sv, "someone"sv, "everyone"sv, "everybody"sv,
    "nothing"sv, "these"sv, "those"sv,  "you"sv,      "whoever"sv, "something"sv};

// What should be so: "the mug should be in the sink", "the spoon goes in the bowl".
inline constexpr std::array kDesire = {"better"sv,  "go"sv,       "goes"sv, "goe"sv,  "belong"sv,
                                       "belongs"sv, "should"sv,   "must"sv, "need"sv, "ought"sv,
                                       "want"sv,    "supposed"sv, "shall"sv};

// What rewriting leaves where a sentence takes a turn.
inline constexpr std::array kTurns = {"correction"sv, "do_that"sv, "hint"sv, "wish_to"sv, "told_of"sv};

// What people rather do themselves: "I want to play, hand me the controller".
inline constexpr std::array kPeopleDo = {"sit"sv,   "rest"sv,  "play"sv, "cook"sv, "bake"sv,
                                         "stand"sv, "clean"sv, "wash"sv, "bring"sv};

// What was ("been a long day", "had a terrible night"): no order begins so.
inline constexpr std::array kPastForms = {
    "been"sv,   "had"sv,   "spent"sv,  "lost"sv,   "got"sv,    "felt"sv,     "slept"sv, "woke"sv,
    "ate"sv,    "went"sv,  "came"sv,   "broke"sv,  "forgot"sv, "was"sv,      "ran"sv,   "met"sv,
    "saw"sv,    "drove"sv, "fell"sv,   "missed"sv, "worked"sv, "finished"sv, "burnt"sv, "stayed"sv,
    "walked"sv, "made"sv,  "bought"sv, "heard"sv,  "took"sv,   "left"sv};

inline constexpr std::array kPossessives = {"my"sv, "your"sv, "his"sv, "her"sv, "our"sv, "their"sv};

// Behind verbs; before clauses that hang on others.
inline constexpr std::array kParticles = {"on"sv,        "off"sv,     "up"sv,     "down"sv,     "out"sv,
                                          "away"sv,      "over"sv,    "in"sv,     "back"sv,     "around"sv,
                                          "through"sv,   "aside"sv,   "along"sv,  "together"sv, "at_home"sv,
                                          "under_tap"sv, "to_boil"sv, "at_tray"sv};
inline constexpr std::array kDeterminers = {"the"sv, "a"sv, "an"sv, "my"sv, "some"sv, "your"sv};
inline constexpr std::array kSubordinate = {"if"sv,     "unless"sv,    "when"sv,    "once"sv,     "after"sv,
                                            "before"sv, "while"sv,     "until"sv,   "because"sv,  "since"sv,
                                            "so"sv,     "where"sv,     "without"sv, "whenever"sv, "as"sv,
                                            "till"sv,   "otherwise"sv, "though"sv,  "although"sv};

}  // namespace word_group
}  // namespace goalnet::inference
