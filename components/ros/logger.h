// Logs to standard error (in the form that rcutils's environment variables ask for) and, through ROS 2, to
// /rosout.
#pragma once

#include <fmt/core.h>

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <version>

#include "components/core/outcome.h"

#ifdef __cpp_lib_source_location
#include <source_location>
#else
#include <experimental/source_location>  // clang before 16, with which the fuzzers are built
#endif

namespace goalnet::ros {

#ifdef __cpp_lib_source_location
using SourceLocation = std::source_location;
#else
using SourceLocation = std::experimental::source_location;
#endif

enum class LogLevel : std::uint8_t {
  kDebug = 10,
  kInfo = 20,
  kWarn = 30,
  kError = 40,
  kFatal = 50
};  // as in Log.msg

Expected<LogLevel> parse_log_level(std::string_view name);  // debug, info, warn(ing), error, fatal; any case

struct LogRecord {
  LogLevel level = LogLevel::kInfo;
  std::string name;  // of the logger
  std::string text;
  SourceLocation where;
};

// A format string, checked by the compiler, that remembers where it was written.
template <class... Args>
struct LogFormat {
  fmt::format_string<Args...> text;
  SourceLocation where;
  template <class Text>
  consteval LogFormat(const Text& format, SourceLocation location = SourceLocation::current())
      : text(format), where(location) {}
};

// Thread-safe, but not for the real-time thread. Texts are cut at 4 KiB.
class Logger {
 public:
  using Sink = std::function<void(const LogRecord&)>;
  explicit Logger(std::string name, LogLevel level = LogLevel::kInfo);
  ~Logger();

  template <class... Args>
  void debug(LogFormat<std::type_identity_t<Args>...> format, Args&&... args) {
    log(LogLevel::kDebug, format.where, format.text, args...);
  }
  template <class... Args>
  void info(LogFormat<std::type_identity_t<Args>...> format, Args&&... args) {
    log(LogLevel::kInfo, format.where, format.text, args...);
  }
  template <class... Args>
  void warn(LogFormat<std::type_identity_t<Args>...> format, Args&&... args) {
    log(LogLevel::kWarn, format.where, format.text, args...);
  }
  template <class... Args>
  void error(LogFormat<std::type_identity_t<Args>...> format, Args&&... args) {
    log(LogLevel::kError, format.where, format.text, args...);
  }
  template <class... Args>
  void fatal(LogFormat<std::type_identity_t<Args>...> format, Args&&... args) {
    log(LogLevel::kFatal, format.where, format.text, args...);
  }

  LogLevel level() const { return level_.load(std::memory_order_relaxed); }
  void set_level(LogLevel level) { level_.store(level, std::memory_order_relaxed); }
  // False: standard error stays quiet (for programs that print for people); /rosout still gets everything.
  void set_console(bool console) { console_.store(console, std::memory_order_relaxed); }
  const std::string& name() const { return name_; }
  void set_sink(Sink sink);  // /rosout; called under no lock but one at a time

 private:
  template <class Format, class... Args>
  void log(LogLevel level, const SourceLocation& where, const Format& format, const Args&... args) {
    if (level >= this->level()) write(level, where, format, fmt::make_format_args(args...));
  }
  void write(LogLevel level, const SourceLocation& where, fmt::string_view format, fmt::format_args args);

  struct Impl;
  const std::string name_;
  std::atomic<LogLevel> level_;
  std::atomic<bool> console_{true};
  std::unique_ptr<Impl> impl_;
};

}  // namespace goalnet::ros
