// Log lines on the console, as a shell of ROS 2 asks for them.
#include "components/ros/console_format.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>

namespace goalnet::ros {
namespace {

constexpr std::int64_t kNow = 1'700'000'000'012'345'678;

LogRecord record() { return {LogLevel::kWarn, "ns.robot", "the tap {} 100 %", SourceLocation::current()}; }

TEST(ConsoleFormat, IsThatOfRos2) {
  EXPECT_EQ(ConsoleFormat().line(record(), kNow),
            "[WARN] [1700000000.012345678] [ns.robot]: the tap {} 100 %");
}

TEST(ConsoleFormat, HasAllOfRcutilsWords) {
  const LogRecord one = record();
  EXPECT_EQ(ConsoleFormat("{file_name}:{line_number} {function_name}|{time_as_nanoseconds}").line(one, kNow),
            std::string(one.where.file_name()) + ":" + std::to_string(one.where.line()) + " " +
                one.where.function_name() + "|1700000000012345678");
  setenv("TZ", "UTC", 1);
  tzset();
  EXPECT_EQ(ConsoleFormat("{date_time_with_ms}").line(one, kNow), "2023-11-14 22:13:20.012");
  unsetenv("TZ");
  tzset();
}

TEST(ConsoleFormat, LeavesWhatItDoesNotKnow) {
  EXPECT_EQ(ConsoleFormat("{{name}} {colour} {nam {").line(record(), kNow), "{ns.robot} {colour} {nam {");
  EXPECT_EQ(ConsoleFormat("").line(record(), kNow), "");
}

TEST(ConsoleFormat, KnowsEscapes) {
  EXPECT_EQ(ConsoleFormat("{name}\\t{message}\\n\\q\\").line(record(), kNow),
            "ns.robot\tthe tap {} 100 %\n\\q\\");
}

TEST(Console, GoesToStandardOutputInColourIfAsked) {
  setenv("RCUTILS_LOGGING_USE_STDOUT", "1", 1);
  setenv("RCUTILS_COLORIZED_OUTPUT", "1", 1);
  Logger there("there");
  unsetenv("RCUTILS_LOGGING_USE_STDOUT");
  setenv("RCUTILS_COLORIZED_OUTPUT", "0", 1);
  Logger plain("plain");
  unsetenv("RCUTILS_COLORIZED_OUTPUT");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  there.warn("one");
  plain.warn("two");
  const std::string err = testing::internal::GetCapturedStderr();
  const std::string out = testing::internal::GetCapturedStdout();
  EXPECT_NE(out.find("[there]: one"), std::string::npos);
  EXPECT_EQ(out.find("\033["), 0u) << "colour";
  EXPECT_NE(err.find("[plain]: two"), std::string::npos);
  EXPECT_EQ(err.find('\033'), std::string::npos);
}

}  // namespace
}  // namespace goalnet::ros
