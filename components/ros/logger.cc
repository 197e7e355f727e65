#include "components/ros/logger.h"

#include <fmt/format.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/stdout_color_sinks.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <mutex>

#include "components/ros/console_format.h"

namespace goalnet::ros {
namespace {

constexpr std::size_t kLongestText = 4096;  // [bytes]

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// rcutils's variables, read once: where lines go, whether in colour, and in which form.
spdlog::sink_ptr make_console() {
  const std::string colour = environment("RCUTILS_COLORIZED_OUTPUT");
  const auto mode = colour == "1"   ? spdlog::color_mode::always
                    : colour == "0" ? spdlog::color_mode::never
                                    : spdlog::color_mode::automatic;
  if (environment("RCUTILS_LOGGING_USE_STDOUT") == "1")
    return std::make_shared<spdlog::sinks::stdout_color_sink_mt>(mode);
  return std::make_shared<spdlog::sinks::stderr_color_sink_mt>(mode);
}

const ConsoleFormat& console_format() {
  static const ConsoleFormat format = [] {
    const std::string wanted = environment("RCUTILS_CONSOLE_OUTPUT_FORMAT");
    return wanted.empty() ? ConsoleFormat() : ConsoleFormat(wanted);
  }();
  return format;
}

spdlog::level::level_enum to_spdlog(LogLevel level) {
  switch (level) {
    case LogLevel::kDebug:
      return spdlog::level::debug;
    case LogLevel::kInfo:
      return spdlog::level::info;
    case LogLevel::kWarn:
      return spdlog::level::warn;
    case LogLevel::kError:
      return spdlog::level::err;
    case LogLevel::kFatal:
      return spdlog::level::critical;
  }
  return spdlog::level::info;
}

}  // namespace

Expected<LogLevel> parse_log_level(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  if (lower == "debug") return LogLevel::kDebug;
  if (lower == "info" || lower == "unset") return LogLevel::kInfo;  // rcl's word for the default
  if (lower == "warn" || lower == "warning") return LogLevel::kWarn;
  if (lower == "error") return LogLevel::kError;
  if (lower == "fatal") return LogLevel::kFatal;
  return fail(Outcome::kInvalidRequest,
              "unknown log level '" + std::string(name) + "'; known: debug, info, warn, error, fatal");
}

struct Logger::Impl {
  spdlog::logger console{"goalnet", make_console()};
  std::mutex mutex;
  Sink sink;
};

Logger::Logger(std::string name, LogLevel level)
    : name_(std::move(name)), level_(level), impl_(std::make_unique<Impl>()) {
  impl_->console.set_level(spdlog::level::trace);
  impl_->console.set_pattern("%^%v%$");  // the line is made here, in ROS 2's form
}

Logger::~Logger() = default;

void Logger::set_sink(Sink sink) {
  std::lock_guard lock(impl_->mutex);
  impl_->sink = std::move(sink);
}

void Logger::write(LogLevel level, const SourceLocation& where, fmt::string_view format,
                   fmt::format_args args) {
  LogRecord record{level, name_, {}, where};
  try {
    record.text = fmt::vformat(format, args);
  } catch (const std::exception& error) {
    record.text = std::string("(message could not be formatted: ") + error.what() + ")";
  }
  if (record.text.size() > kLongestText) record.text.resize(kLongestText);
  if (console_.load(std::memory_order_relaxed)) {
    const auto ns = std::chrono::duration_cast<std::chrono::nanoseconds>(
                        std::chrono::system_clock::now().time_since_epoch())
                        .count();
    impl_->console.log(to_spdlog(level), "{}", console_format().line(record, ns));
  }
  std::lock_guard lock(impl_->mutex);
  if (impl_->sink) impl_->sink(record);
}

}  // namespace goalnet::ros
