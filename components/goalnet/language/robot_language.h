// All that a robot knows of English: config/language, loaded afresh and independent of any trained model.
#pragma once

#include <memory>
#include <string>

#include "components/goalnet/language/frames.h"
#include "components/goalnet/language/reading_confidence.h"

namespace goalnet::inference {

class RobotLanguage {
 public:
  // Reads household.json, english.json, words.json, confidence.json and kinds.json. Fails with
  // kInvalidRequest: which file, what is wrong.
  static Expected<std::unique_ptr<RobotLanguage>> load(Symbols& symbols);

  struct Reading {
    Understanding understanding;
    Instruction instruction;  // the objects, by this language's classes
    Words words;
  };
  // `tokens` as tokenize() gives them. `distances` may be null.
  Reading read(const std::vector<std::string>& tokens, const std::vector<std::string>& objects,
               const SymState& start, const Distances* distances);

  const ReadingConfidence& confidence() const { return confidence_; }

 private:
  // other_readings.cc: `reading` becomes one that makes sense where there is one.
  void other_readings(const std::vector<std::string>& tokens, const FrameReader& reader,
                      const SymState& start, const Distances* distances, Reading& reading);
  std::vector<std::string> with_known_verbs(const std::vector<std::string>& tokens) const;
  std::vector<std::string> without_describing(const std::vector<std::string>& tokens) const;
  bool names_nothing(const std::vector<std::string>& tokens, std::size_t begin, std::size_t end) const;
  explicit RobotLanguage(Symbols& symbols) : symbols_(symbols) {}

  Symbols& symbols_;
  std::unique_ptr<Lexicon> lexicon_;
  std::unique_ptr<Language> language_;
  ReadingConfidence confidence_;
};

}  // namespace goalnet::inference
