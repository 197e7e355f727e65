// The words around a slip of the tongue: what is a thing, what goes on behind it, what people say when they
// notice.
#pragma once

#include <string>
#include <vector>

namespace goalnet::inference {

class Language;

// What people say when they notice that something was wrong; `at` where it is not that. Some of it is said
// elsewhere too and counts only with a pause behind it ("wait by the tv", "no syrup").
std::size_t interjection(const std::vector<std::string>& words, std::size_t at, bool& sure);
// "(hmm,) all three", "just one", "make it both": how many; `at` where it is none.
std::size_t quantity(const std::vector<std::string>& words, std::size_t at, std::string& many);

class SlipWords {
 public:
  SlipWords(const std::vector<std::string>& words, const Language& language)
      : words_(words), language_(language) {}

  // Where the thing or number begins that ends before `at`, with its article; `at` where there is none.
  std::size_t thing_begin(std::size_t at) const;
  bool said_in(std::size_t begin, std::size_t end, const std::string& word) const;
  bool goes_on_at(std::size_t i) const;
  // Whether the word at `i` was said in the sentence that ends before `end`.
  bool said_before(std::size_t end, std::size_t i) const;
  static bool hesitates(const std::string& word);
  bool named_before(std::size_t at) const;
  // Whether the sentence before tells how many.
  bool counted_before(std::size_t at) const;
  // A thing or a place and nothing else: "the fork", "burner four", "in the sink", "two", "the second".
  // `open`: the part may go on behind it.
  std::size_t thing(std::size_t at, bool open = false) const;
  // Whether no list goes on at `at`: "sorry, the fork and the plate" may be all that is wanted.
  bool tail(std::size_t at) const;

 private:
  bool small(std::size_t i) const;
  // How many words at `i` make a name; 0 for none.
  std::size_t name(std::size_t i) const;
  bool is_tail(std::size_t i) const;

 protected:
  const std::vector<std::string>& words_;
  const Language& language_;
};

}  // namespace goalnet::inference
