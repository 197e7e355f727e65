// The parts of a message between its pauses, and what each is made of; for ellipsis.cc.
#pragma once

#include <vector>

#include "components/goalnet/language/noun_phrase.h"

namespace goalnet::inference {

// What a part between two pauses is made of.
enum class Part : std::uint8_t { kOther, kThings, kPlace, kCountAtPlace, kVerb };

struct Span {
  std::size_t begin = 0, end = 0;  // without the pause behind it
  Part part = Part::kOther;
  bool with_preposition = false;
  std::size_t content = 0;  // where the things or the place begin, behind "and", "then", "please"
};

class PartReader {
 public:
  // `words`, `language` and `lexicon` must outlive this; the words may not change meanwhile.
  PartReader(const Words& words, const Language& language, const Lexicon& lexicon)
      : words_(words), language_(language), lexicon_(lexicon), reader_(words, language, lexicon) {}

  std::vector<Span> spans() const;
  const NounPhraseReader& phrases() const { return reader_; }
  // Whether the word changes nothing where it stands.
  bool harmless(std::size_t at) const;
  // "tap running", "the tv is off": where the device ends of which only this is told; `span.content` where it
  // is something else.
  std::size_t told_device(const Span& span) const;
  // "off", "on please": on or off and nothing else.
  bool only_switches(const Span& span) const;
  // A subject and a verb, as no command begins.
  bool tells(const Span& span) const;

 private:
  Span span(std::size_t begin, std::size_t end) const;

  const Words& words_;
  const Language& language_;
  const Lexicon& lexicon_;
  NounPhraseReader reader_;
};

}  // namespace goalnet::inference
