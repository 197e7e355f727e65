// Model files: what we write we read back; what is broken or hostile is refused with one clear message.
#include "components/goalnet/safetensors.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace goalnet::inference {
namespace {

using ::testing::HasSubstr;

std::vector<std::byte> file_of(const std::string& header, std::size_t data_bytes,
                               std::int64_t announced = -1) {
  std::vector<std::byte> file(8 + header.size() + data_bytes);
  const std::uint64_t length = announced < 0 ? header.size() : static_cast<std::uint64_t>(announced);
  std::memcpy(file.data(), &length, 8);
  std::memcpy(file.data() + 8, header.data(), header.size());
  return file;
}

std::string refusal(const std::string& header, std::size_t data_bytes = 0, std::int64_t announced = -1) {
  const auto result = SafeTensors::parse(file_of(header, data_bytes, announced), "bad.safetensors");
  if (result) return "accepted";
  EXPECT_EQ(result.error().outcome, Outcome::kInvalidRequest);
  EXPECT_THAT(result.error().message, HasSubstr("bad.safetensors"));
  EXPECT_LT(result.error().message.size(), 300u);
  return result.error().message;
}

SafeTensorsWriter small_writer() {
  SafeTensorsWriter writer;
  const std::vector<float> matrix = {1, 2, 3, 4, 5, 6};
  EXPECT_TRUE(writer.add("matrix", {2, 3}, matrix));
  EXPECT_TRUE(writer.add("vector", {2}, std::vector<float>{-1.5F, 0.25F}));
  EXPECT_TRUE(writer.add("nothing", {0, 4}, {}));
  writer.metadata("kind", "test");
  return writer;
}

TEST(SafeTensors, WhatIsWrittenIsReadBack) {
  const auto read = SafeTensors::parse(small_writer().bytes(), "memory");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->tensors().size(), 3u);
  EXPECT_EQ(*read->metadata("kind"), "test");
  const auto matrix = read->floats("matrix", std::vector<std::uint64_t>{2, 3});
  ASSERT_TRUE(matrix) << matrix.error().message;
  EXPECT_EQ(matrix->values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(read->floats("nothing", std::vector<std::uint64_t>{0, 4})->values.size(), 0u);
}

TEST(SafeTensors, TheSameContentGivesTheSameBytes) {
  EXPECT_EQ(small_writer().bytes(), small_writer().bytes());
  EXPECT_EQ(small_writer().bytes().size() % 4, 0u);
}

TEST(SafeTensors, FilesAreWrittenWholeOrNotAtAll) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("safetensors_test_" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  const std::string path = folder / "model.safetensors";
  ASSERT_TRUE(small_writer().write(path));
  EXPECT_TRUE(SafeTensors::load(path));
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
  EXPECT_FALSE(small_writer().write(folder / "no" / "such" / "folder"));
  EXPECT_THAT(SafeTensors::load(folder / "absent").error().message, HasSubstr("no such model file"));
  EXPECT_THAT(SafeTensors::load(folder).error().message, HasSubstr("not a regular file"));
  std::filesystem::remove_all(folder);
}

TEST(SafeTensors, EveryTruncationIsRefused) {
  const std::vector<std::byte> whole = small_writer().bytes();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto result =
        SafeTensors::parse({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}, "cut");
    ASSERT_FALSE(result) << "accepted at " << size << " of " << whole.size() << " bytes";
  }
}

TEST(SafeTensors, EveryFlippedHeaderByteIsReadOrRefusedWithoutHarm) {
  const std::vector<std::byte> whole = small_writer().bytes();
  for (std::size_t place = 0; place < whole.size(); ++place) {
    for (const int flip : {0x01, 0x20, 0x80, 0xff}) {
      std::vector<std::byte> file = whole;
      file[place] ^= static_cast<std::byte>(flip);
      const auto result = SafeTensors::parse(std::move(file), "flipped");
      EXPECT_TRUE(result.has_value() || !result.error().message.empty());
    }
  }
}

TEST(SafeTensors, HostileHeaders) {
  const std::string tensor = R"("dtype":"F32","shape":[2],"data_offsets":[0,8])";
  EXPECT_EQ(refusal("{\"a\":{" + tensor + "}}", 8), "accepted");
  EXPECT_THAT(refusal("{\"a\":{" + tensor + "}}", 8, 1ll << 40), HasSubstr("larger than admitted"));
  EXPECT_THAT(refusal("{\"a\":{" + tensor + "}}", 8, 1000), HasSubstr("ends inside its header"));
  EXPECT_THAT(refusal("{\"a\":{" + tensor + "}}", 4), HasSubstr("lies outside the file"));
  EXPECT_THAT(refusal("{\"a\":{" + tensor + "}}", 12), HasSubstr("belong to nothing"));
  EXPECT_THAT(refusal(" {}"), HasSubstr("does not start with '{'"));
  EXPECT_THAT(refusal("{\"a\":"), HasSubstr("not JSON"));
  EXPECT_THAT(refusal("{\"a\":{\"dtype\":\"F8\"}}"), HasSubstr("unknown dtype \"F8\""));
  EXPECT_THAT(refusal("{\"a\":{\"dtype\":\"F32\"}}"), HasSubstr("no dtype, shape or data_offsets"));
  EXPECT_THAT(refusal("{\"a\":{" + tensor + "},\"a\":{" + tensor + "}}", 8), HasSubstr("duplicate"));
  EXPECT_THAT(refusal("{\"a\":{" + tensor + ",\"dtype\":\"F32\"}}", 8), HasSubstr("duplicate field"));
  EXPECT_THAT(refusal("{\"a\":{" + tensor + ",\"x\":1}}", 8), HasSubstr("unknown field"));
  EXPECT_THAT(refusal("{\"a\":{" + tensor + "},\"b\":{" + tensor + "}}", 8), HasSubstr("overlaps"));
  EXPECT_THAT(refusal(R"({"a":{"dtype":"F32","shape":[1],"data_offsets":[4,8]}})", 8), HasSubstr("gap"));
  EXPECT_THAT(refusal(R"({"a":{"dtype":"F32","shape":[3],"data_offsets":[0,8]}})", 8),
              HasSubstr("another length"));
  EXPECT_THAT(refusal(R"({"a":{"dtype":"F32","shape":[2],"data_offsets":[8,0]}})", 8), HasSubstr("outside"));
  EXPECT_THAT(refusal(R"({"a":{"dtype":"F32","shape":[4611686018427387904,4],"data_offsets":[0,8]}})", 8),
              HasSubstr("another length"));
  EXPECT_THAT(refusal(R"({"a":{"dtype":"F32","shape":[-1],"data_offsets":[0,8]}})", 8),
              HasSubstr("negative"));
  EXPECT_THAT(refusal(R"({"a":{"dtype":"F32","shape":[1.5],"data_offsets":[0,8]}})", 8),
              HasSubstr("not whole"));
  EXPECT_THAT(refusal(R"({"a":{"dtype":"F32","shape":[1,1,1,1,1,1,1,1,2],"data_offsets":[0,8]}})", 8),
              HasSubstr("too many"));
  EXPECT_THAT(refusal(R"({"a":{"dtype":"F32","shape":[[2]],"data_offsets":[0,8]}})", 8), HasSubstr("list"));
  EXPECT_THAT(refusal(R"({"a":{"b":{"c":{}}}})"), HasSubstr("unknown field"));
  EXPECT_THAT(refusal(R"({"a":{"dtype":{"c":{}}}})"), HasSubstr("too deeply"));
  EXPECT_THAT(refusal(R"({"__metadata__":{"a":"1","a":"2"}})"), HasSubstr("duplicate metadata key"));
  EXPECT_THAT(refusal(R"({"__metadata__":{"a":1}})"), HasSubstr("number where none belongs"));
  EXPECT_THAT(refusal("{\"\xff\":{" + tensor + "}}", 8), HasSubstr("not JSON"));
  EXPECT_THAT(refusal("{" + std::string(100000, '[')), HasSubstr("not JSON"));
  EXPECT_THAT(refusal("{\"a\":" + std::string(100000, '[')), HasSubstr("list where none belongs"));
  EXPECT_THAT(refusal("[]"), HasSubstr("does not start"));
  EXPECT_THAT(refusal("{} {}"), HasSubstr("not JSON"));
}

TEST(SafeTensors, TooManyTensorsAreRefused) {
  std::string header = "{";
  for (int i = 0; i < 20; ++i) {
    if (i > 0) header += ',';
    header += "\"t";
    header += static_cast<char>('a' + i);
    header += R"(":{"dtype":"F32","shape":[0],"data_offsets":[0,0]})";
  }
  TensorLimits limits;
  limits.max_tensors = 10;
  const auto result = SafeTensors::parse(file_of(header + "}", 0), "many", limits);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("more tensors"));
}

TEST(SafeTensors, WrongShapesTypesAndValuesNameTheTensor) {
  SafeTensorsWriter writer = small_writer();
  ASSERT_TRUE(writer.add("bad", {1}, std::vector<float>{std::nanf("")}));
  const auto read = SafeTensors::parse(writer.bytes(), "memory");
  ASSERT_TRUE(read);
  EXPECT_THAT(read->floats("matrix", std::vector<std::uint64_t>{3, 2}).error().message,
              HasSubstr("shape [2, 3], needed is [3, 2]"));
  EXPECT_TRUE(read->floats("matrix", std::vector<std::uint64_t>{0, 3}));
  EXPECT_THAT(read->floats("absent", {}).error().message, HasSubstr("\"absent\" is missing"));
  EXPECT_THAT(read->floats("bad", std::vector<std::uint64_t>{1}).error().message, HasSubstr("not finite"));
  EXPECT_FALSE(read->metadata("absent"));
  EXPECT_FALSE(writer.add("wrong", {3}, std::vector<float>{1}));
}

TEST(SafeTensors, HalfPrecisionIsRead) {
  auto file = file_of(
      R"({"h":{"dtype":"F16","shape":[4],"data_offsets":[0,8]},"b":{"dtype":"BF16","shape":[1],"data_offsets":[8,10]}})",
      10);
  const std::uint16_t halves[5] = {0x3c00, 0xc000, 0x0001, 0x3555,
                                   0x3fc0};  // 1, -2, 2^-24, 0.33325, and 1.5 in bfloat16
  std::memcpy(file.data() + file.size() - 10, halves, 10);
  const auto read = SafeTensors::parse(std::move(file), "memory");
  ASSERT_TRUE(read) << read.error().message;
  const auto values = read->floats("h", std::vector<std::uint64_t>{4})->values;
  EXPECT_EQ(values[0], 1.0F);
  EXPECT_EQ(values[1], -2.0F);
  EXPECT_EQ(values[2], std::ldexp(1.0F, -24));
  EXPECT_NEAR(values[3], 1.0 / 3, 1e-4);
  EXPECT_EQ(read->floats("b", std::vector<std::uint64_t>{1})->values[0], 1.5F);
}

}  // namespace
}  // namespace goalnet::inference
