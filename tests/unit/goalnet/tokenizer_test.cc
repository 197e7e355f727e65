#include "components/goalnet/tokenizer.h"

#include <gtest/gtest.h>

namespace goalnet::inference {
namespace {

using Words = std::vector<std::string>;

TEST(Tokenizer, LowersLettersAndSplitsPunctuation) {
  EXPECT_EQ(*tokenize("Fill the Mug_1, please!"), (Words{"fill", "the", "mug_1", ",", "please", "."}));
  EXPECT_EQ(*tokenize("coca-cola"), (Words{"coca", "cola"}));
  EXPECT_EQ(*tokenize("the pot's lid"), (Words{"the", "pot", "lid"}));
  EXPECT_EQ(*tokenize("cook 2/3 of it"), (Words{"cook", "2/3", "of", "it"}));
  EXPECT_EQ(*tokenize("... wait ... go"), (Words{".", "wait", ".", "go"}));
}

TEST(Tokenizer, EmptyTextHasNoWords) {
  EXPECT_TRUE(tokenize("")->empty());
  EXPECT_TRUE(tokenize(" \t\n")->empty());
}

TEST(Tokenizer, TypographicQuotesCountAsAscii) { EXPECT_EQ(*tokenize("cd\u2019s"), Words{"cd"}); }

TEST(Tokenizer, ShortFormsAndSigns) {
  EXPECT_EQ(*tokenize("it's dark, let's go"), (Words{"it", "is", "dark", ",", "let", "us", "go"}));
  EXPECT_EQ(*tokenize("don't: cups & plates"), (Words{"dont", ",", "cups", "and", "plates"}));
}

TEST(Tokenizer, PicturesSeparateAndAccentsFall) {
  EXPECT_EQ(*tokenize("mug \u2192 sink \U0001F642"), (Words{"mug", "sink"}));
  EXPECT_EQ(*tokenize("caf\u00e9 \u00c9t\u00e9"), (Words{"cafe", "ete"}));
}

TEST(Tokenizer, OtherScriptsMakeUnknownWords) {
  EXPECT_EQ(*tokenize("открой fridge"), (Words{"открой", "fridge"}));
}

TEST(Tokenizer, RefusesWhatIsNoText) {
  for (const std::string& text :
       {std::string("a\x01g"), std::string("a\0b", 3), std::string("\xff\xfe"), std::string("\xc0\xaf"),
        std::string("\xed\xa0\x80"), std::string("cut \xe2\x82")}) {
    const auto words = tokenize(text);
    ASSERT_FALSE(words);
    EXPECT_EQ(words.error().outcome, Outcome::kInvalidRequest);
    EXPECT_NE(words.error().message.find("byte"), std::string::npos) << words.error().message;
  }
}

TEST(Tokenizer, RefusesTooMuch) {
  EXPECT_EQ(tokenize(std::string(100000, 'a')).error().outcome, Outcome::kInvalidRequest);
  std::string many;
  for (int i = 0; i < 300; ++i) many += "a ";
  EXPECT_NE(tokenize(many).error().message.find("256"), std::string::npos);
}

}  // namespace
}  // namespace goalnet::inference
