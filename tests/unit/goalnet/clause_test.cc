// Sentences as clauses, read with the words of config/language/household.json alone, as models without
// English are.
#include "components/goalnet/language/clause.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "components/goalnet/lexicon.h"

namespace goalnet::inference {
namespace {

TEST(Clauses, AnAdverbBeforeAPauseIsNobodysName) {
  const std::string path = GOALNET_SOURCE_DIR "/config/language/household.json";
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  Symbols symbols;
  const Lexicon lexicon = *Lexicon::load(path, symbols);
  const Language language = *Language::parse(text.str(), path, lexicon, symbols);
  const Words words = normal_words({"which", "is", "silly", ",", "open", "the", "fridge"}, language);
  const ParsedSentence parsed = parse_clauses(words, language, lexicon);
  ASSERT_FALSE(parsed.clauses.empty());
  EXPECT_EQ(parsed.clauses.back().frame, Frame::kOpen);
}

}  // namespace
}  // namespace goalnet::inference
