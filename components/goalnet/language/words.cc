#include "components/goalnet/language/words.h"

#include <algorithm>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/slips.h"
#include "components/goalnet/language/spoken_forms.h"
#include "components/goalnet/language/ways_of_saying.h"
#include "components/goalnet/language/word_order.h"
#include "components/goalnet/lexicon.h"
#include "components/goalnet/tokenizer.h"

namespace goalnet::inference {
namespace {

constexpr std::size_t kMaxAfterRewriting = 2 * kMaxWords;  // rewriting may lengthen a sentence

// "x box" -> "xbox", "micro wave" -> "microwave": two pieces that mean something only together.
void join_pieces(std::vector<std::string>& tokens, const Language& language) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    const std::string joined = tokens[i] + tokens[i + 1];
    const bool pieces = tokens[i].size() < 2 || !language.known(tokens[i]) || !language.known(tokens[i + 1]);
    if (!pieces || joined.size() < 4 || !language.names_something(joined)) continue;
    tokens[i] = joined;
    tokens.erase(tokens.begin() + static_cast<long>(i) + 1);
  }
}

// "putthe", "turnon": two words without the blank between them; one of them a small word.
bool split(const std::string& token, const Language& language, std::vector<std::string>& out) {
  if (token.size() < 5 || language.real_word(token)) return false;
  for (std::size_t at = 1; at + 1 < token.size(); ++at) {
    const std::string a = token.substr(0, at), b = token.substr(at);
    const bool small_first = language.small_word(a), small_second = language.small_word(b);
    if (!(small_first || small_second) || a.size() + b.size() < 5) continue;
    if (!(small_first || language.meaningful(a)) || !(small_second || language.meaningful(b))) continue;
    out.push_back(a), out.push_back(b);
    return true;
  }
  return false;
}

// "1. open the fridge 2. take the coke": the numbers only part the sentences.
void drop_numbering(std::vector<std::string>& tokens) {
  if (tokens.size() < 3 || tokens[0] != "1" || tokens[1] != ".") return;
  int next = 1;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i)
    if (tokens[i] == std::to_string(next) && tokens[i + 1] == ".") {
      tokens.erase(tokens.begin() + static_cast<long>(i));
      ++next;
    }
}

// "cup2", "burner3": the number is a word of its own
void part_numbers(std::vector<std::string>& tokens, const Language& language) {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::size_t digit = tokens[i].find_last_not_of("0123456789") + 1;
    if (digit == 0 || digit + 1 != tokens[i].size() || !language.names_thing(tokens[i].substr(0, digit)))
      continue;
    const std::string number = tokens[i].substr(digit);
    tokens[i].resize(digit);
    tokens.insert(tokens.begin() + static_cast<long>(i) + 1, number);
  }
}

// "int he sink": the blank slipped by one letter.
void move_blanks(std::vector<std::string>& tokens, const Language& language) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    std::string &a = tokens[i], &b = tokens[i + 1];
    if (a.size() < 3 || (language.known(a) && language.known(b)) || !language.small_word(a.back() + b))
      continue;
    const std::string shorter = a.substr(0, a.size() - 1);
    if (!language.known(shorter)) continue;
    b = a.back() + b, a = shorter;
  }
}

bool is_state(const std::string& word, const Language& language) {
  return language.wanted_by_state(word) != Frame::kNone || language.complaint(word) != Frame::kNone;
}

// "sooo" -> "so", "loooud" -> "loud"; the word itself where that is none.
std::string without_drawl(const std::string& word, const Language& language) {
  std::string once, twice;
  for (const char letter : word) {
    if (once.empty() || once.back() != letter) once += letter;
    const std::size_t n = twice.size();
    if (n < 2 || twice[n - 1] != letter || twice[n - 2] != letter) twice += letter;
  }
  const bool digits = word.find_first_of("0123456789") != std::string::npos;
  if (twice == word || digits || once.size() < 2) return word;
  return language.known(twice) ? twice : language.known(once) ? once : word;
}

// "runing" -> "running"; empty for what does not end so.
std::string with_doubled(const std::string& word) {
  if (word.size() < 6 || !word.ends_with("ing")) return {};
  const std::string stem = word.substr(0, word.size() - 3);
  return stem + stem.back() + "ing";
}

// "mmm", "ssh", "brr": one or two letters, none of them a vowel; of people also "ehm", "uhh".
bool is_sound(const std::string& word, bool hears_people) {
  constexpr std::size_t kLongest = 5;
  if (hears_people && word.size() > 1 && word.size() <= kLongest &&
      word.find_first_not_of("aehmru") == std::string::npos)
    return true;
  std::string letters = word;
  std::sort(letters.begin(), letters.end());
  letters.erase(std::unique(letters.begin(), letters.end()), letters.end());
  return word.size() > 2 && letters.size() <= 2 &&
         letters.find_first_of("aeiouy0123456789") == std::string::npos;
}

// Brings what is said as people say it into the order that the grammar reads.
void in_usual_order(std::vector<std::string>& text, const Language& language) {
  drop_repetitions(text, language);
  drop_false_starts(text, language);
  drop_nameless(text, language);
  drop_measures(text, language);
  ask_for_any(text, language);
  part_run_ons(text, language);
  drop_topics_named_again(text, language);
  drop_lead_ins(text, language);
  mark_retractions(text, language);
  want_what_it_is(text, language);
  keep_the_contrast(text, language);
  say_what_was_left_undone(text, language);
  mend_what_annoys(text, language);
  say_what_is_not_heard(text, language);
  wish_what_is_far(text, language);
  turn_on_what_is_to_be_seen(text, language);
  put_where_wanted(text, language);
  counts_said_after(text, language);
  numbers_said_after(text, language);
  descriptions_said_after(text, language);
  things_said_after(text, language);
  places_said_after(text, language);
  subjects_first(text, language);
  answer_what_should_be(text, language);
  uncleave(text, language);
  let_it_go(text, language);
  verbs_first(text, language);
  places_last(text, language);
  wished_things_last(text, language);
  name_what_comes_last(text, language);
  say_whose_it_is(text, language);
  spell_out_steps(text, language);
  join_thing_and_place(text, language);
  put_it_there(text, language);
  short_places(text, language);
}

// A word as the grammar knows it, typing errors mended: none for a sound, two where the blank was left out.
void add_mended(const std::string& token, const Language& language, std::vector<std::string>& text) {
  const bool people = language.hears_people();
  if (const std::string doubled = people ? with_doubled(token) : std::string();
      !doubled.empty() && is_state(doubled, language) && !is_state(token, language))
    return text.push_back(doubled);
  if (language.known(token)) return text.push_back(token);
  if (is_sound(token, people)) return;
  if (const std::string drawled = without_drawl(token, language); people && drawled != token)
    return text.push_back(drawled);
  if (const std::string& other = language.synonym(token); other != token) return text.push_back(other);
  if (people && token.size() > 4 && token.ends_with("in") && language.known(token + "g"))
    return text.push_back(token + "g");  // "drippin"
  if (split(token, language, text)) return;
  std::string mended = language.correct(token);
  const bool lost_s = mended != token && token.size() > 4 && token.back() == 's' && mended.back() != 's' &&
                      language.names_something(mended);
  text.push_back(lost_s ? mended + "s" : std::move(mended));  // "pilows" are pillows
}

// What is said as people say it, before phrases are made equal.
void as_people_say_it(std::vector<std::string>& text, const Language& language) {
  in_usual_order(text, language);
  mark_slips(text, language);
  drop_thrown_in(text, language);
  drop_relative_parts(text, language);
  wishes_first(text);
  last_requests(text, language);
  needs_first(text);
  no_places(text);
  reasons_of_corrections(text);
  afterthoughts_first(text);
  not_but(text);
  name_the_one(text, language);
}

// The words by their stems, and which of them were plural.
Words by_stems(std::vector<std::string> text, const Language& language) {
  Words words;
  for (std::string& word : text) {
    std::string stem = language.keeps_its_s(word) ? word : singular(word);
    if (word == "lies" && language.hears_people()) stem = "lie";
    if (word == "ones" && language.hears_people()) stem = "one";
    words.plural.push_back(stem != word);
    words.text.push_back(std::move(stem));
  }
  return words;
}

}  // namespace

Words normal_words(const std::vector<std::string>& tokens, const Language& language) {
  std::vector<std::string> mended = tokens;
  if (language.hears_people()) {
    expand_contractions(mended, language);
    resolve_headings(mended, language);
    resolve_endings(mended, language);
    drop_tags(mended, language);
    part_numbers(mended, language);
  }
  drop_numbering(mended);
  move_blanks(mended, language);
  join_pieces(mended, language);
  std::vector<std::string> text;
  for (const std::string& token : mended) add_mended(token, language, text);
  if (language.hears_people()) as_people_say_it(text, language);
  say_plainly(text, language);
  // Rules may speak of where a sentence begins and ends.
  if (text.empty() || text.back() != ".") text.emplace_back(".");
  text.insert(text.begin(), ".");
  text = language.rewrite(std::move(text), kMaxAfterRewriting);
  if (language.hears_people()) {
    wished_past(text);
    repeat_the_wish(text, language);
    supply_what_lacks(text, language);
    join_pauses(text);
  }
  join_wishes(text);
  return by_stems(std::move(text), language);
}

}  // namespace goalnet::inference
