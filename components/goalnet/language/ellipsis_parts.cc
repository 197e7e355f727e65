#include "components/goalnet/language/ellipsis_parts.h"

#include <array>

#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

bool PartReader::harmless(std::size_t i) const {
  const std::string& word = words_.text[i];
  return (language_.filler(word) || language_.adverb(word)) && language_.verb(word) == Frame::kNone &&
         !place_preposition(word) && !is_pronoun(word) && !one_of(word, kPointers) &&
         !one_of(word, kPersons) && !one_of(word, kParticles) && !language_.asks(word);
}

Span PartReader::span(std::size_t begin, std::size_t end) const {
  Span span{.begin = begin, .end = end};
  std::size_t i = begin;
  while (i < end && (language_.joins(words_.text[i]) ||
                     (harmless(i) && number_word(words_.text[i]) == 0 && !reader_.starts(i, end))))
    ++i;
  if (i < end && words_.text[i] == "back" && i + 1 < end && place_preposition(words_.text[i + 1])) ++i;
  span.content = i;
  if (i >= end) return span;
  const auto rest_is_small = [&](std::size_t from) {
    for (std::size_t k = from; k < end; ++k)
      if (!harmless(k) && words_.text[k] != "too") return false;
    return true;
  };
  NounPhrase phrase;
  if (number_word(words_.text[i]) > 0 && i + 1 < end && reader_.name_length(i + 1) == 0) {
    const std::size_t verb = one_of(words_.text[i + 1], kDesire) ? 1 : 0;  // "one goes on the table"
    const std::size_t done = reader_.read_place(i + 1 + verb, end, phrase);
    if (done != i + 1 + verb && rest_is_small(done)) {
      span.part = Part::kCountAtPlace;
      return span;
    }
  }
  phrase = {};
  if (const std::size_t done = reader_.read_place(i, end, phrase); done != i) {
    if (rest_is_small(done) && !phrase.person && !phrase.pronoun && !phrase.unknown && !phrase.hand)
      span.part = Part::kPlace, span.with_preposition = true;
    return span;
  }
  bool things = false, places = false;
  for (std::size_t k = i; k < end;) {
    phrase = {};
    const std::size_t done = reader_.read(k, end, phrase);
    if (done == k || phrase.person || phrase.pronoun || phrase.unknown || phrase.phrase.empty()) {
      things = places = false;
      break;
    }
    static constexpr std::array kBins = {"bin"sv, "trash"sv, "garbage"sv, "rubbish"sv};  // "coke, trash"
    const bool bin = begin > 0 && one_of(phrase.phrase, kBins) && done == end;
    const bool furniture = lexicon_.is_place_name(phrase.phrase) || bin;
    things = things || !furniture, places = places || furniture;
    k = done;
    if (rest_is_small(k)) break;
    if (words_.text[k] != "and") {
      things = places = false;
      break;
    }
    ++k;
  }
  if (things != places) span.part = things ? Part::kThings : Part::kPlace;
  if (language_.verb(words_.text[i]) != Frame::kNone && reader_.name_length(i) == 0 && rest_is_small(i + 1))
    span.part = Part::kVerb;
  return span;
}

std::size_t PartReader::told_device(const Span& span) const {
  static constexpr std::array kSwitched = {"on"sv, "off"sv, "running"sv, "lit"sv, "going"sv};
  if (span.end < span.content + 2 || !one_of(words_.text[span.end - 1], kSwitched)) return span.content;
  if (language_.verb(words_.text[span.content]) != Frame::kNone && reader_.name_length(span.content) == 0)
    return span.content;
  std::size_t end = span.end - 1;
  while (end > span.content && (language_.copula(words_.text[end - 1]) || words_.text[end - 1] == "still"))
    --end;
  NounPhrase device;
  const bool named = reader_.read(span.content, end, device) == end && !device.phrase.empty() &&
                     !device.person && !device.pronoun && !device.unknown;
  return named ? end : span.content;
}

bool PartReader::only_switches(const Span& span) const {
  if (span.content >= span.end || (words_.text[span.content] != "on" && words_.text[span.content] != "off"))
    return false;
  for (std::size_t k = span.content + 1; k < span.end; ++k)
    if (!harmless(k)) return false;
  return true;
}

bool PartReader::tells(const Span& span) const {
  for (std::size_t k = span.begin + 1; k < span.end; ++k)
    if (language_.copula(words_.text[k])) return true;
  return false;
}

std::vector<Span> PartReader::spans() const {
  std::vector<Span> spans;
  for (std::size_t begin = 0; begin < words_.text.size();) {
    std::size_t end = begin;
    while (end < words_.text.size() && words_.text[end] != "." && words_.text[end] != ",") ++end;
    if (end > begin) spans.push_back(span(begin, end));
    begin = end + 1;
  }
  return spans;
}

}  // namespace goalnet::inference
