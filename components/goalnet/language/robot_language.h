// All that a robot knows of English: config/language, loaded afresh and independent of any trained model.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "components/goalnet/gist/gist_model.h"
#include "components/goalnet/language/background.h"
#include "components/goalnet/language/frames.h"
#include "components/goalnet/language/reading_confidence.h"
#include "components/goalnet/language/sentence_parts.h"

namespace goalnet::inference {

class RobotLanguage {
 public:
  // Reads household.json, english.json, words.json, confidence.json, kinds.json, talk.json, background.json
  // and gist.safetensors. Fails with kInvalidRequest: which file, what is wrong.
  // `guesses`: false for who makes the last of them.
  static Expected<std::unique_ptr<RobotLanguage>> load(Symbols& symbols, bool guesses = true);

  struct Reading {
    Understanding understanding;
    Instruction instruction;  // the objects, by this language's classes
    Words words;
    bool beyond_robot = false;  // a part asks for what no robot here can do
  };
  // `tokens` as tokenize() gives them. `distances` may be null.
  Reading read(const std::vector<std::string>& tokens, const std::vector<std::string>& objects,
               const SymState& start, const Distances* distances);

  // What a complete reading of the tokens shows of how sure to be.
  struct Judgement {
    Signs signs{};
    std::vector<std::string> unused;  // what it leaves unused, for messages
  };
  Judgement judge(const std::vector<std::string>& tokens, const Reading& reading, const SymState& start,
                  const Distances* distances) const;
  const ReadingConfidence& confidence() const { return confidence_; }

  // What a message that was not read is most likely about (gist/): a sentence that is read, for people to
  // confirm; nothing where there is none.
  struct Guess {
    std::string sentence;
    double probability = 0;
    bool sure = false;       // enough to do it unasked
    bool overrules = false;  // sure enough to doubt a reading by which nothing is to be done
    Reading reading;         // of the sentence
  };
  std::optional<Guess> guess(const std::vector<std::string>& tokens, const Reading& refused,
                             const std::vector<std::string>& objects, const SymState& start,
                             const Distances* distances);
  // What the words are and what could be asked for, for that.
  struct Sight {
    gist::Views views;
    Instruction here;
  };
  Sight see(const std::vector<std::string>& tokens, const std::vector<std::string>& objects,
            const SymState& start);
  const Lexicon& lexicon() const { return *lexicon_; }
  const Language& language() const { return *language_; }
  double background(const SentencePart& part) const { return background_.of(part.signs); }  // 0..1
  std::vector<SentencePart> parts(const std::vector<std::string>& tokens) const;
  // As the grammar reads them first: see normal_words().
  std::vector<std::string> words(const std::vector<std::string>& tokens) const {
    return normal_words(tokens, *language_).text;
  }
  // The words with those parts set aside.
  std::vector<std::string> without(const std::vector<std::string>& tokens,
                                   const std::vector<SentencePart>& parts,
                                   const std::vector<bool>& aside) const;

 private:
  // guess.cc
  bool may_be_done_unasked(const gist::Message& message, const gist::Likely& likely,
                           const Reading& refused) const;
  bool uses_all(const gist::Message& message, const gist::Likely& likely) const;
  // other_readings.cc: `reading` becomes one that makes sense where there is one.
  void other_readings(const std::vector<std::string>& tokens, const FrameReader& reader,
                      const SymState& start, const Distances* distances, Reading& reading);
  struct WithoutBackground {
    std::vector<std::string> words;
    std::vector<std::vector<std::string>> less;  // without one more part that surely asks for something
  };
  // set_aside.cc: the words without what is most likely background, the most probable choice first.
  std::vector<WithoutBackground> without_background(const std::vector<std::string>& tokens) const;
  bool asks_for_unknown(const std::vector<std::string>& tokens, const SentencePart& part) const;
  bool needs_unknown(const std::vector<std::string>& tokens, const SentencePart& part) const;
  bool idle(const std::vector<std::string>& tokens, const SentencePart& part) const;
  std::vector<std::string> with_known_verbs(const std::vector<std::string>& tokens) const;
  std::vector<std::string> without_describing(const std::vector<std::string>& tokens) const;
  bool names_nothing(const std::vector<std::string>& tokens, std::size_t begin, std::size_t end) const;
  // The objects as this language knows them, with parts that worlds do not list.
  Instruction objects_here(const std::vector<std::string>& objects);
  explicit RobotLanguage(Symbols& symbols) : symbols_(symbols), gist_({}) {}

  Symbols& symbols_;
  std::unique_ptr<Lexicon> lexicon_;
  std::unique_ptr<Language> language_;
  ReadingConfidence confidence_;
  Background background_;
  gist::GistModel gist_;
};

}  // namespace goalnet::inference
