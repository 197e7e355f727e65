#include "components/core/read_file.h"

#include <gmock/gmock-matchers.h>
#include <unistd.h>

#include <fstream>

namespace goalnet {
namespace {

using testing::HasSubstr;

TEST(ReadFile, GivesAllBytesUpToTheLimit) {
  const auto path = std::filesystem::temp_directory_path() / ("read_file_" + std::to_string(getpid()));
  const std::string content = std::string(100'000, 'a') + '\0' + "\xff\n";
  std::ofstream(path, std::ios::binary) << content;
  EXPECT_EQ(read_file(path, content.size()).value(), content);
  EXPECT_THAT(read_file(path, content.size() - 1).error().message, HasSubstr("larger"));
  std::ofstream(path, std::ios::binary) << "";
  EXPECT_EQ(read_file(path, 0).value(), "");
  std::filesystem::remove(path);
  EXPECT_THAT(read_file(path, 10).error().message, HasSubstr("No such file"));
}

TEST(ReadFile, NeitherFoldersNorFilesWithoutEnd) {
  EXPECT_THAT(read_file("/tmp", 10).error().message, HasSubstr("folder"));
  EXPECT_THAT(read_file("/dev/zero", 1 << 20).error().message, HasSubstr("larger than 1 MB"));
}

}  // namespace
}  // namespace goalnet
