#include "components/goalnet/lexicon.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace goalnet::inference {
namespace {

Lexicon load(Symbols& symbols) {
  return Lexicon::load(GOALNET_SOURCE_DIR "/config/language/household.json", symbols).value();
}

TEST(Words, SingularsOfPlurals) {
  EXPECT_EQ(singular("pillows"), "pillow");
  EXPECT_EQ(singular("shelves"), "shelf");
  EXPECT_EQ(singular("glasses"), "glass");
  EXPECT_EQ(singular("glass"), "glass");
  EXPECT_EQ(singular("its"), "its");
  EXPECT_TRUE(is_plural("books"));
  EXPECT_FALSE(is_plural("book"));
}

TEST(Words, SpokenNames) {
  EXPECT_EQ(spoken_name("LongCup_1"), "long cup");
  EXPECT_EQ(spoken_name("Tv_1Remote_1"), "tv remote");
}

TEST(Lexicon, NamesByLevel) {
  Symbols symbols;
  Lexicon lexicon = load(symbols);
  const auto level = [&](const char* phrase, const char* object) {
    const Symbol symbol = symbols.intern(object);
    return lexicon.names(phrase, symbol, lexicon.class_of(symbol, symbols));
  };
  EXPECT_EQ(level("pot", "Kettle"), NameLevel::kName);
  EXPECT_EQ(level("cup", "Mug_1"), NameLevel::kGeneric);
  EXPECT_EQ(level("chocolate syrup", "Syrup_2"), NameLevel::kOwnName);
  EXPECT_EQ(level("chocolate syrup", "Syrup_1"), NameLevel::kNone);
  EXPECT_EQ(level("pot", "Sink"), NameLevel::kNone);
}

TEST(Lexicon, UnlistedObjectsAreNamedByTheirNames) {
  Symbols symbols;
  Lexicon lexicon = load(symbols);
  const Symbol lamp = symbols.intern("FloorLamp_3"), mug = symbols.intern("Mug_7");
  EXPECT_EQ(lexicon.names("floor lamp", lamp, lexicon.class_of(lamp, symbols)), NameLevel::kName);
  EXPECT_EQ(lexicon.class_of(mug, symbols), lexicon.class_of(symbols.intern("Mug_1"), symbols));
}

TEST(Lexicon, CompletesTheRoomOfAState) {
  Symbols symbols;
  const Lexicon lexicon = load(symbols);
  WorldState state;
  state.objects = {"Kettle", "Mug_1", "Robot", "Sink"};
  lexicon.complete_objects(state);
  const auto has = [&](const char* name) {
    return std::count(state.objects.begin(), state.objects.end(), name) == 1;
  };
  EXPECT_TRUE(has("StoveFire_3"));
  EXPECT_TRUE(has("Microwave"));
  EXPECT_FALSE(has("Tv_1"));
}

TEST(Lexicon, BadFilesAreRefused) {
  Symbols symbols;
  for (const char* text :
       {"", "{}", "[]", R"({"classes": {"mug": 3}})", R"({"classes": {}, "objects": [], "rooms": 1})"}) {
    const auto lexicon = Lexicon::parse(text, "words.json", symbols);
    ASSERT_FALSE(lexicon) << text;
    EXPECT_NE(lexicon.error().message.find("words.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace goalnet::inference
