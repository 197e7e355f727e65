// One step's input as numbers: per object a few active features, the graph of relations, and what is true
// now.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace goalnet::inference::network {

// Features of an object other than the values of its states, which follow from kFirstValue on.
enum Feature : int {
  kHeld,
  kNearRobot,
  kOnSomething,
  kInSomething,
  kCarriesSomething,
  kGraspable,
  kSqueezeable,
  kUnknownClass,
  kOnlyOfItsClass,
  kInstance0,  // no number in its name; 1 to 4 follow, higher ones count as 4
  kGrounded = kInstance0 + 5,
  kGroundedShare,                      // 1 / number of objects the same word may mean
  kGroundedRank0,                      // the order of mention: first, second, third, later
  kLexiconSense = kGroundedRank0 + 4,  // the probability that a word of the sentence means this class
  kLexiconRank0,
  kFullName = kLexiconRank0 + 4,  // every word of its name stands in the sentence
  kPartialName,                   // one of them does
  kSimilarWord,                   // the closest word of the sentence, by cosine of word vectors above 0.3
  kLastMain,                      // the last goal was about it
  kEverMain,                      // an earlier goal was
  kLastSecond,                    // it was a place or container of the last goal
  kEverSecond,
  kFirstValue
};

struct FeatureItem {
  int feature;
  float value;
};

// A directed edge of the relation graph: `to` hears from `from`.
struct RelationEdge {
  int from, to;
  int type;  // 0: from lies on to; 1: the other way; 2 and 3: the same for In
};
inline constexpr int kEdgeTypes = 4;

// A predicate of an earlier goal. Slots are of the NameTable; -1 where there is none.
struct PastPredicate {
  int token;
  int main_slot, second_slot, value;
  bool operator==(const PastPredicate&) const = default;
};

// Everything the network reads, beside the sentence. Reused from step to step; clear() keeps the memory.
struct EncodedWorld {
  int objects = 0;
  std::vector<int> slot;      // by object: the name's slot in the NameTable
  std::vector<int> class_id;  // by object, -1 when unknown
  std::vector<FeatureItem> items;
  std::vector<int> first_item;  // objects + 1: where an object's items start
  std::vector<RelationEdge> edges;
  std::vector<std::uint8_t> mentioned, held, near, graspable;  // by object
  std::vector<std::uint8_t> value;                             // objects x values
  std::vector<PastPredicate> past;                             // of all earlier goals
  std::vector<int> first_past;                                 // goals + 1

  std::span<const FeatureItem> items_of(int object) const {
    const auto begin = static_cast<std::size_t>(first_item[static_cast<std::size_t>(object)]);
    const auto end = static_cast<std::size_t>(first_item[static_cast<std::size_t>(object) + 1]);
    return std::span(items).subspan(begin, end - begin);
  }
  std::span<const PastPredicate> past_of(int goal) const {
    const auto begin = static_cast<std::size_t>(first_past[static_cast<std::size_t>(goal)]);
    const auto end = static_cast<std::size_t>(first_past[static_cast<std::size_t>(goal) + 1]);
    return std::span(past).subspan(begin, end - begin);
  }
};

}  // namespace goalnet::inference::network
