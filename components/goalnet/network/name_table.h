// What the network knows of an object by its name alone: class, words, word vector. Filled as names are met.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "components/goalnet/network/lexicon.h"
#include "components/goalnet/network/tensors.h"

namespace goalnet::inference::network {

struct NameEntry {
  int class_id = -1;           // in the lexicon, -1 when this class was never seen
  int instance = 0;            // 0 without a number
  std::vector<int> words;      // known words of the name
  std::size_t word_count = 0;  // all words of the name
  Vector unit;                 // mean of the stored word vectors, length 1; zero when no word is known
};

// Slots stay valid until clear(). Looking up a known name allocates nothing.
class NameTable {
 public:
  NameTable(const Lexicon& lexicon, const Matrix& word_vectors);

  int slot(std::string_view name);
  const NameEntry& entry(int slot) const { return entries_[static_cast<std::size_t>(slot)]; }
  std::size_t size() const { return entries_.size(); }
  // Callers clear between sentences when a hostile stream of names has made the table large.
  void clear();

 private:
  const Lexicon& lexicon_;
  const Matrix& vectors_;
  std::vector<NameEntry> entries_;
  TextMap slots_;
};

// Object names of one world to their places in it. Rebuilt per state without allocating once it is large
// enough.
class NameIndex {
 public:
  // Keeps views of `names`. A name that stands twice gets its first place.
  void rebuild(std::span<const std::string> names);
  int find(std::string_view name) const;  // -1 when absent

 private:
  std::vector<int> buckets_;
  std::span<const std::string> names_;
};

}  // namespace goalnet::inference::network
