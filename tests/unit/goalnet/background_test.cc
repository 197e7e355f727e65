// What is set aside of a message, and what never is.
#include "components/goalnet/language/background.h"

#include <gtest/gtest.h>

#include "components/goalnet/language/robot_language.h"
#include "components/goalnet/tokenizer.h"
#include "tests/unit/goalnet/instruction_fixture.h"

namespace goalnet::inference {
namespace {

class BackgroundTest : public InstructionFixture {
 protected:
  void SetUp() override {
    auto loaded = RobotLanguage::load(symbols);
    ASSERT_TRUE(loaded) << loaded.error().message;
    language = std::move(*loaded);
  }
  std::vector<std::string> texts(const std::string& sentence) {
    std::vector<std::string> result;
    const auto tokens = *tokenize(sentence, Endings::kKept);
    for (const SentencePart& part : language->parts(tokens)) {
      result.emplace_back();
      for (std::size_t i = part.begin; i < part.end; ++i)
        result.back() += (i == part.begin ? "" : " ") + tokens[i];
    }
    return result;
  }
  std::vector<double> likely(const std::string& sentence) {
    std::vector<double> result;
    for (const SentencePart& part : language->parts(*tokenize(sentence, Endings::kKept)))
      result.push_back(language->background(part));
    return result;
  }
  static InstructionRunner::Run follow(const std::string& sentence) {
    return InstructionFixture::follow("kitchen", sentence);
  }

  Symbols symbols;
  std::unique_ptr<RobotLanguage> language;
};

TEST_F(BackgroundTest, PartsEndAtPunctuationAndWhereClausesBegin) {
  EXPECT_EQ(texts("I bought it ages ago, put the mug in the sink so it gets clean and bring me the fork"),
            (std::vector<std::string>{"i bought it ages ago", "put the mug in the sink", "so it gets clean",
                                      "and bring me the fork"}));
  EXPECT_EQ(texts("the plate and the fork"), std::vector<std::string>{"the plate and the fork"});
  EXPECT_TRUE(texts("").empty());
}

TEST_F(BackgroundTest, RequestsAndBackgroundAreToldApart) {
  const auto p = likely("I was working all night long, put the mug in the sink");
  ASSERT_EQ(p.size(), 2u);
  EXPECT_GT(p[0], 0.5);
  EXPECT_LT(p[1], 0.1);
}

TEST_F(BackgroundTest, WhatIsSetAsideMayStillBeIt) {
  std::vector<SentencePart> parts = language->parts(*tokenize("I like the mug, bring it", Endings::kKept));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(language->without(*tokenize("I like the mug, bring it", Endings::kKept), parts, {true, false}),
            (std::vector<std::string>{"told_of", "the", "mug", ",", "bring", "it"}));
}

// Half of what was asked for is no answer.
TEST_F(BackgroundTest, NothingThatIsAskedForIsSetAside) {
  for (const char* sentence :
       {"bring me the mug and a napkin", "paint the wall and bring me the mug",
        "bring me the mug, a napkin and the fork", "put the mug in the sink unless the moon is full",
        "peel the potatoes, then put the plate in the sink", "open the fridge if you smell smoke"})
    EXPECT_TRUE(follow(sentence).refused) << sentence;
}

TEST_F(BackgroundTest, ABadTableIsRefused) {
  for (const char* text :
       {"", "[]", R"({"bias": 1})", R"({"bias": "x", "weights": {}})", R"({"weights": {"a": 1}})"}) {
    const auto background = Background::parse(text, "background.json");
    ASSERT_FALSE(background) << text;
    EXPECT_NE(background.error().message.find("background.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace goalnet::inference
