// What a message that the grammar cannot read is most likely about.
#include <gtest/gtest.h>

#include <unistd.h>
#include <filesystem>
#include <fstream>
#include <set>

#include "components/goalnet/gist/features.h"
#include "components/goalnet/gist/wording.h"
#include "components/goalnet/language/robot_language.h"
#include "components/goalnet/safetensors.h"
#include "components/goalnet/tokenizer.h"
#include "tests/unit/goalnet/instruction_fixture.h"

namespace goalnet::inference {
namespace {

using gist::Ask;

class GistTest : public InstructionFixture {
 protected:
  // Refused, and asked in these words whether that was meant.
  static void expect_offer(const std::string& room, const std::string& sentence, const std::string& offer) {
    const auto run = follow(room, sentence);
    EXPECT_TRUE(run.refused) << sentence;
    EXPECT_TRUE(run.message.ends_with("; did you mean \"" + offer + "\"?"))
        << sentence << ": " << run.message;
  }
  static void expect_no_offer(const std::string& room, const std::string& sentence) {
    const auto run = follow(room, sentence);
    EXPECT_TRUE(run.refused) << sentence;
    EXPECT_EQ(run.message.find("did you mean"), std::string::npos) << sentence << ": " << run.message;
  }
};

TEST_F(GistTest, WhatIsMostLikelyMeantIsOffered) {
  expect_offer("living_room", "I wouldn't mind if you brought me a book.", "take the book");
  expect_offer("kitchen", "A glass of water to take my pills with, please.", "fill the glass with water");
}

TEST_F(GistTest, YesIsAnAnswerToTheLastOfferOnly) {
  follow("kitchen", "A glass of water to take my pills with, please.");
  expect_reached("kitchen", "Yes, please.", "(state Glass_1 Water)");
  EXPECT_TRUE(follow("kitchen", "yes").refused);
  follow("kitchen", "A glass of water to take my pills with, please.");
  expect_reached("kitchen", "bring me the mug", "(Grasping Robot Mug_1)");
  EXPECT_TRUE(follow("kitchen", "yes").refused);
  follow("kitchen", "A glass of water to take my pills with, please.");
  EXPECT_TRUE(follow("kitchen", "no").refused);
  EXPECT_TRUE(follow("kitchen", "yes").refused);
}

TEST_F(GistTest, ThatAllIsSoAlreadyIsDoubtedWhereSomethingElseIsLikelyMeant) {
  expect_offer("living_room", "Pray betake yourself to the television and wait there.",
               "go to the television");
  const auto run = follow("living_room", "if the tv is on channel 5, change to 4");
  EXPECT_FALSE(run.refused) << run.message;  // it is on channel 3
}

TEST_F(GistTest, WhatIsSureAndSimpleIsDone) {
  expect_reached("kitchen", "From fridge energy drink to me bring.", "(Grasping Robot EnergyDrink_1)");
  expect_reached("kitchen", "Would you have the great kindness to replenish the kettle with fresh water?",
                 "(state Kettle Water)");
}

TEST_F(GistTest, WhatIsForbiddenOrForLaterIsNotOffered) {
  expect_no_offer("kitchen", "you must not turn on the tap");
  expect_no_offer("kitchen", "do not fill the kettle");
}

TEST_F(GistTest, WhatDependsOnSomethingOrIsDeniedIsAtMostOffered) {
  for (const char* sentence :
       {"otherwise turn on the tap", "I see no reason to fill the kettle",
        "phone the doctor, then bring me the glass", "who asked you to turn on the tap?",
        "open the window and close the fridge", "er, that, coke, scratch me I am beer, bring"})
    EXPECT_TRUE(follow("kitchen", sentence).refused) << sentence;
}

TEST_F(GistTest, AMessageOfManyNamesIsBoundedInTime) {
  std::string sentence = "yonder";
  for (int i = 0; i < 120; ++i) sentence += i % 2 == 0 ? " mug" : " sink";
  EXPECT_TRUE(follow("kitchen", sentence).refused);
}

// Every request is put into words that the grammar reads.
TEST(GistWording, IsReadByTheGrammar) {
  Symbols symbols;
  auto language = RobotLanguage::load(symbols);
  ASSERT_TRUE(language) << language.error().message;
  const Rooms rooms;
  const auto wording = [&](const std::string& room, const std::string& sentence) {
    const WorldState world = rooms.room(room, "");
    const SymState start = to_sym_state(world.facts, symbols);
    const auto sight = (*language)->see(*tokenize(sentence, Endings::kKept), world.objects, start);
    std::set<Ask> asks;
    for (const gist::Request& request : sight.views.front().requests) {
      const std::string words = gist::in_words(sight.views, {request}, (*language)->language());
      const auto reading = (*language)->read(*tokenize(words, Endings::kKept), world.objects, start, nullptr);
      if (reading.understanding.complete) asks.insert(request.ask);
    }
    return asks;
  };
  const std::set<Ask> kitchen =
      wording("kitchen", "mug sink water fridge burner two tap coffee bowl ice cream");
  for (const Ask ask :
       {Ask::kOpen, Ask::kTake, Ask::kMoveAway, Ask::kEmpty, Ask::kFillWithWater, Ask::kFill, Ask::kPut,
        Ask::kTurnOn, Ask::kTurnOff, Ask::kLightBurner, Ask::kGo, Ask::kHeat, Ask::kClose})
    EXPECT_TRUE(kitchen.contains(ask)) << static_cast<int>(ask);
  const std::set<Ask> living_room = wording("living_room", "beer tv three");
  for (const Ask ask : {Ask::kDiscard, Ask::kChannel, Ask::kMute, Ask::kUnmute})
    EXPECT_TRUE(living_room.contains(ask)) << static_cast<int>(ask);
}

TEST(GistModel, FilesThatAreNoneAreNamed) {
  const auto file =
      std::filesystem::temp_directory_path() / ("gist_" + std::to_string(getpid()) + ".safetensors");
  const auto message = [&] {
    const auto model = gist::GistModel::load(file.string());
    return model ? std::string() : model.error().message;
  };
  EXPECT_NE(message().find(file.string()), std::string::npos);
  std::ofstream(file) << "no tensors";
  EXPECT_NE(message().find(file.string()), std::string::npos);
  ASSERT_TRUE(gist::GistModel(std::vector<float>(gist::kFeatures, 0.5f)).save(file.string(), "test"));
  const auto model = gist::GistModel::load(file.string());
  ASSERT_TRUE(model) << model.error().message;
  const std::uint32_t two[] = {1, gist::kFeatures - 1};
  EXPECT_FLOAT_EQ(model->score(two), 1.0f);
  SafeTensorsWriter small;
  const std::vector<float> few(8);
  ASSERT_TRUE(small.add("weights", {8}, few));
  ASSERT_TRUE(small.write(file.string()));
  EXPECT_NE(message().find("weights"), std::string::npos) << message();
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace goalnet::inference
