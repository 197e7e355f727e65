// The shipped goal model: the feature-sharing ranker with minimum-Bayes-risk decoding, and the reading of
// plain instructions by their grammar beside it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "components/goalnet/goal_model.h"
#include "components/goalnet/language/frames.h"
#include "components/goalnet/language/language.h"
#include "components/goalnet/language/robot_language.h"
#include "components/goalnet/ranker/ranker.h"
#include "components/goalnet/safetensors.h"

namespace goalnet::inference {

// The texts of config/language that a model carries with it; english and words may be empty.
struct LanguageTexts {
  std::string household, english, words;
};
// Reads household.json, english.json and words.json. kInvalidRequest: which cannot be read.
Expected<LanguageTexts> read_language_texts();

// Everything a trained model consists of.
struct RankerParts {
  Symbols symbols;
  std::unique_ptr<Lexicon> lexicon;  // Language refers to it
  std::unique_ptr<Language> language;
  LanguageTexts texts;
  std::vector<std::string> known_words;  // of the training sentences
  Ranker given, none;                    // trained with and without the demonstrations' grounding
  std::string fingerprint, command;      // of the data; what trained it
};

// Lexicon and Language from their texts.
Expected<RankerParts> make_parts(LanguageTexts texts, const std::string& name);

// The options as the model file has them.
std::string to_json(const RankerOptions& options);
// Reads and writes the model file. Reading checks everything; kInvalidRequest says what is wrong.
Expected<RankerParts> read_ranker(const SafeTensors& file);
Expected<void> write_ranker(const RankerParts& parts, const std::string& path);

class RankerModel : public GoalModel {
 public:
  RankerModel(RankerParts parts, ModelUse use);
  // Needed before infer() where the use is kRobot: config/language. Fails with kInvalidRequest.
  Expected<void> read_language();
  std::string_view kind() const override { return "ranker"; }
  // Of the instruction read last (kRobot): what its confidence was made of.
  const Signs& signs() const { return signs_; }

 private:
  // The whole run that is meant, as the goals of its steps.
  struct Decoded {
    std::vector<Goal> steps;
    Error refusal;
    bool refused = false;
  };
  Expected<Goal> do_infer(const StepInput& input) override;
  Decoded decode(const StepInput& input);
  Decoded decode_benchmark(const Instruction& instruction, const SymState& start, std::uint64_t seed);
  Decoded decode_robot(const StepInput& input, std::vector<std::string> words, const SymState& start);
  Decoded steps_of(const Understanding& understanding, double confidence);
  Decoded offer(const RobotLanguage::Guess& guess, Error refusal);
  // What is done or asked instead of a refusal.
  Decoded guessed(const StepInput& input, const std::vector<std::string>& words, const SymState& start,
                  const RobotLanguage::Reading& refused, Error refusal);

  RankerParts parts_;
  std::unique_ptr<RobotLanguage> robot_;  // refers to parts_.symbols
  ModelUse use_;
  Signs signs_{};
  std::uint64_t decoded_for_ = 0;  // fingerprint of the input that decoded_ answers
  Decoded decoded_;
  std::string offered_;  // what the last message was guessed to mean; "yes" is the answer to that
};

}  // namespace goalnet::inference
