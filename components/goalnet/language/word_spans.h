// Where things, places and parts of a sentence begin and end, before any grammar: for what is mended in the
// words themselves.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace goalnet::inference {

class Language;

// A look at words that are owned elsewhere and may not change meanwhile.
class WordSpans {
 public:
  WordSpans(const std::vector<std::string>& words, const Language& language)
      : words_(words), language_(language) {}

  // At a pause or the end.
  bool ends(std::size_t at) const;
  // Where a part may begin: at the beginning, behind a pause.
  bool begins(std::size_t at) const { return at == 0 || ends(at - 1); }
  std::size_t part_begin(std::size_t at) const;
  std::size_t part_end(std::size_t at) const;
  // Whether `word` stands at `at`.
  bool is(std::size_t at, std::string_view word) const { return at < words_.size() && words_[at] == word; }
  bool is_one(std::size_t at, std::initializer_list<std::string_view> words) const;
  // Behind the phrase of these words that stands at `at`; `at` where none does.
  std::size_t phrase(std::size_t at, std::initializer_list<std::string_view> phrases) const;
  // Behind "please", "so", "and", "oh" and the like.
  std::size_t skip_small(std::size_t at) const;

  // How many words at `at` make the name of a thing, a place or a content; 0 for none.
  std::size_t name(std::size_t at) const;
  // Behind "both empty cups", "the burner two", "a glass of water", "them all": `at` where there is none.
  std::size_t thing(std::size_t at) const;
  // Behind "the plate and the bowl".
  std::size_t things(std::size_t at) const;
  // Behind "in the sink", "from the shelf".
  std::size_t place(std::size_t at) const;
  // Behind "in the sink" or "the sink".
  std::size_t somewhere(std::size_t at) const;
  // Whether a name stands in [from, to).
  bool names(std::size_t from, std::size_t to) const;
  // Whether an order begins at `at`: a verb in its plain form that is no name here.
  bool order(std::size_t at) const;
  // Whether some part of [from, to) begins as orders do, behind "can you", "please", ...
  bool orders(std::size_t from, std::size_t to) const;

 private:
  const std::vector<std::string>& words_;
  const Language& language_;
};

// The words of [from, to).
std::vector<std::string> cut(const std::vector<std::string>& words, std::size_t from, std::size_t to);
// Puts `with` in the place of [from, to).
void replace(std::vector<std::string>& words, std::size_t from, std::size_t to,
             const std::vector<std::string>& with);

}  // namespace goalnet::inference
