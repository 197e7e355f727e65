// WordPiece as the uncased BERT models do it, and refusals of broken sentence encoders.
#include "components/goalnet/encoder/wordpiece.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include "components/goalnet/encoder/bert_weights.h"

namespace goalnet::inference {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const WordPiece& pieces() {
  //                      0      1      2      3     4      5      6     7    8     9     10
  static const WordPiece kPieces =
      WordPiece::parse("[PAD]\n[UNK]\n[CLS]\n[SEP]\nmicro\n##wave\nwave\n##s\ncafe\n,\nput\n", "vocab")
          .value();
  return kPieces;
}

TEST(WordPiece, LongestPiecesFirst) {
  EXPECT_THAT(pieces().encode("put microwave", 20), ElementsAre(2, 10, 4, 5, 3));
  EXPECT_THAT(pieces().encode("Microwaves, PUT", 20), ElementsAre(2, 4, 5, 7, 9, 10, 3));
  EXPECT_THAT(pieces().encode("waves", 20), ElementsAre(2, 6, 7, 3));
}

TEST(WordPiece, AWordWithoutPiecesIsUnknownAsAWhole) {
  EXPECT_THAT(pieces().encode("wavex put", 20), ElementsAre(2, 1, 10, 3));
  EXPECT_THAT(pieces().encode(std::string(200, 'w'), 20), ElementsAre(2, 1, 3));
}

TEST(WordPiece, AccentsSpacesAndBrokenText) {
  EXPECT_THAT(pieces().encode("Caf\xc3\xa9", 20), ElementsAre(2, 8, 3));
  EXPECT_THAT(pieces().encode("put\xc2\xa0wave", 20), ElementsAre(2, 10, 6, 3));
  EXPECT_THAT(pieces().encode("p\xffut\x01", 20), ElementsAre(2, 10, 3));
  EXPECT_THAT(pieces().encode("\xe6\xb0\xb4put", 20),
              ElementsAre(2, 1, 10, 3));  // a Chinese character is a word
  EXPECT_THAT(pieces().encode("", 20), ElementsAre(2, 3));
  std::string all(256, ' ');
  for (int i = 0; i < 256; ++i) all[static_cast<std::size_t>(i)] = static_cast<char>(i);
  EXPECT_LE(pieces().encode(all, 20).size(), 20u);
}

TEST(WordPiece, LongTextIsCut) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "put ";
  const auto ids = pieces().encode(text, 16);
  EXPECT_EQ(ids.size(), 16u);
  EXPECT_EQ(ids.back(), 3);
}

TEST(WordPiece, AVocabularyWithoutItsMarksIsRefused) {
  EXPECT_THAT(WordPiece::parse("a\nb\n", "vocab.txt").error().message, HasSubstr("lacks [UNK]"));
  EXPECT_FALSE(WordPiece::load("/nonexistent/vocab.txt"));
}

TEST(BertWeights, BrokenFilesNameWhatIsWrong) {
  SafeTensorsWriter writer;
  ASSERT_TRUE(writer.add("embeddings.word_embeddings.weight", {3, 4}, std::vector<float>(12)));
  const auto file = SafeTensors::parse(writer.bytes(), "bert");
  const auto message = [&](const std::string& config) {
    return load_bert_weights(*file, config).error().message;
  };
  EXPECT_THAT(message("{"), HasSubstr("num_attention_heads"));
  EXPECT_THAT(message(R"({"num_attention_heads": 3})"), HasSubstr("do not divide"));
  EXPECT_THAT(message(R"({"num_attention_heads": 2, "hidden_act": "relu"})"), HasSubstr("gelu"));
  EXPECT_THAT(message(R"({"num_attention_heads": 2})"), HasSubstr("position_embeddings"));
}

}  // namespace
}  // namespace goalnet::inference
