#include "components/goalnet/language/phrase_rules.h"

#include <gtest/gtest.h>

#include <sstream>

namespace goalnet::inference {
namespace {

PhraseRules::Phrase words(const std::string& text) {
  std::istringstream stream(text);
  PhraseRules::Phrase result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

std::string said(const PhraseRules& rules, const std::string& text, std::size_t most = 100) {
  std::string result;
  for (const std::string& word : rules.apply(words(text), most)) result += (result.empty() ? "" : " ") + word;
  return result;
}

TEST(PhraseRules, TheLongestPhraseCounts) {
  PhraseRules rules;
  EXPECT_TRUE(rules.empty());
  rules.add(words("turn up"), words("raise"));
  rules.add(words("turn up the stove"), words("turn on the stove"));
  EXPECT_FALSE(rules.empty());
  EXPECT_EQ(said(rules, "please turn up the stove"), "please turn on the stove");
  EXPECT_EQ(said(rules, "turn up the volume"), "raise the volume");
  EXPECT_EQ(said(rules, "turn up"), "raise");
  EXPECT_EQ(said(rules, "turn"), "turn");
  EXPECT_EQ(said(rules, ""), "");
}

TEST(PhraseRules, TheFirstRuleForTheSameWordsCounts) {
  PhraseRules rules;
  rules.add(words("telly"), words("tv"));
  rules.add(words("telly"), words("television"));
  EXPECT_EQ(said(rules, "telly on"), "tv on");
}

TEST(PhraseRules, WhatWasWrittenMayBePartOfALongerPhrase) {
  PhraseRules rules;
  rules.add(words("telly"), words("tv"));
  rules.add(words("kill the tv"), words("turn off the tv"));
  rules.add(words("hush"), {});
  EXPECT_EQ(said(rules, "hush kill the telly"), "turn off the tv");
}

TEST(PhraseRules, APatternIsAllTheWaysToReadIt) {
  PhraseRules rules;
  const PhraseRules::Groups groups = {{"$thing", {words("mug"), words("long cup")}}, {"$to", {words("to")}}};
  ASSERT_TRUE(
      rules.add_pattern(words("put|set the| $thing over+there"), words("place $thing there"), groups));
  EXPECT_EQ(said(rules, "put the mug over there"), "place mug there");
  EXPECT_EQ(said(rules, "set long cup over there"), "place long cup there");
  EXPECT_EQ(said(rules, "put the long over there"), "put the long over there");
}

TEST(PhraseRules, AGroupOutsideOfThePatternIsAWordAndTheFirstOfTwoCounts) {
  PhraseRules rules;
  const PhraseRules::Groups groups = {{"$n", {words("one"), words("two")}}};
  ASSERT_TRUE(rules.add_pattern(words("from $n to $n"), words("at $n $m"), groups));
  EXPECT_EQ(said(rules, "from two to one"), "at two $m");
}

TEST(PhraseRules, EachWordIsToldOnce) {
  PhraseRules rules;
  rules.add(words("mug to mug"), words("cup"));
  ASSERT_TRUE(rules.add_pattern(words("mug|glass to"), words("vessel"), {}));
  EXPECT_EQ(rules.words(), words("mug to glass"));
}

TEST(PhraseRules, TheResultIsNeverLongerThanAsked) {
  PhraseRules rules;
  rules.add(words("both"), words("the one and the other"));
  EXPECT_EQ(said(rules, "take both", 7), "take the one and the other");
  EXPECT_EQ(said(rules, "take both", 6), "take both");
  rules.add(words("more"), words("more more"));  // ends, too
  EXPECT_EQ(rules.apply(words("more"), 50).size(), 49u);
}

TEST(PhraseRules, ManyRulesAreAllFound) {
  PhraseRules rules;
  for (int i = 0; i < 5000; ++i)
    rules.add({"w" + std::to_string(i), "w" + std::to_string(i * 7 % 5000)}, {"r" + std::to_string(i)});
  for (int i = 0; i < 5000; ++i)
    EXPECT_EQ(said(rules, "w" + std::to_string(i) + " w" + std::to_string(i * 7 % 5000)),
              "r" + std::to_string(i));
}

TEST(PhraseRules, ABadPatternSaysWhy) {
  PhraseRules rules;
  const auto why = [&](const std::string& from, const PhraseRules::Groups& groups) {
    const auto added = rules.add_pattern(words(from), words("x"), groups);
    return added ? "" : added.error().message;
  };
  EXPECT_EQ(why("take $thing", {}), "there is no group $thing");
  EXPECT_EQ(why("the| a|", {}), "a pattern may match no word at all");
  EXPECT_EQ(why("a|b a|b a|b a|b a|b a|b a|b a|b a|b a|b a|b a|b a|b a|b a|b", {}),
            "a pattern has too many ways to be read");
  PhraseRules::Groups seven;
  std::string from;
  for (char name = 'a'; name < 'h'; ++name) {
    const std::string group = std::string("$") + name;
    seven[group] = {{"x"}}, from += group + " ";
  }
  EXPECT_EQ(why(from, seven), "a pattern has too many groups");
}

}  // namespace
}  // namespace goalnet::inference
