// How a log line looks on the console: the form that RCUTILS_CONSOLE_OUTPUT_FORMAT asks for, by rcutils's
// rules.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "components/ros/logger.h"

namespace goalnet::ros {

inline constexpr const char* kUsualConsoleFormat = "[{severity}] [{time}] [{name}]: {message}";

// Text with {severity}, {name}, {message}, {function_name}, {file_name}, {line_number}, {time} (seconds with
// nanoseconds), {time_as_nanoseconds} and {date_time_with_ms} (local time) in it; \n, \t and the like stand
// for what they do in C. Anything else in braces stays as it is.
class ConsoleFormat {
 public:
  explicit ConsoleFormat(std::string_view format = kUsualConsoleFormat);

  // `now` in nanoseconds since 1970.
  std::string line(const LogRecord& record, std::int64_t now) const;

 private:
  enum class Part : std::uint8_t {
    kText,
    kSeverity,
    kName,
    kMessage,
    kFunction,
    kFile,
    kLine,
    kTime,
    kNanoseconds,
    kDate
  };
  struct Piece {
    Part part = Part::kText;
    std::string text;  // of kText
  };
  void add_text(std::string_view text);

  std::vector<Piece> pieces_;
};

}  // namespace goalnet::ros
