#include "components/ros/console_format.h"

#include <fmt/format.h>

#include <ctime>
#include <utility>

namespace goalnet::ros {
namespace {

const char* label(LogLevel level) {
  switch (level) {
    case LogLevel::kDebug:
      return "DEBUG";
    case LogLevel::kInfo:
      return "INFO";
    case LogLevel::kWarn:
      return "WARN";
    case LogLevel::kError:
      return "ERROR";
    case LogLevel::kFatal:
      return "FATAL";
  }
  return "INFO";
}

std::string local_time(std::int64_t now) {
  const std::time_t seconds = now / 1'000'000'000;
  std::tm split{};
  localtime_r(&seconds, &split);
  char text[32];
  const std::size_t size = std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &split);
  return fmt::format("{}.{:03}", std::string_view(text, size), now / 1'000'000 % 1000);
}

std::string unescaped(std::string_view text) {
  static constexpr std::string_view kLetters = "abfnrtv\\", kMeanings = "\a\b\f\n\r\t\v\\";
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t known =
        text[i] == '\\' && i + 1 < text.size() ? kLetters.find(text[i + 1]) : std::string_view::npos;
    if (known != std::string_view::npos) ++i;
    out += known != std::string_view::npos ? kMeanings[known] : text[i];
  }
  return out;
}

}  // namespace

ConsoleFormat::ConsoleFormat(std::string_view format) {
  static constexpr std::pair<std::string_view, Part> kParts[] = {
      {"{severity}", Part::kSeverity},
      {"{name}", Part::kName},
      {"{message}", Part::kMessage},
      {"{function_name}", Part::kFunction},
      {"{file_name}", Part::kFile},
      {"{line_number}", Part::kLine},
      {"{time}", Part::kTime},
      {"{time_as_nanoseconds}", Part::kNanoseconds},
      {"{date_time_with_ms}", Part::kDate},
  };
  while (!format.empty()) {
    const auto brace = format.find('{');
    add_text(format.substr(0, brace));
    if (brace == std::string_view::npos) return;
    format.remove_prefix(brace);
    std::string_view taken = format.substr(0, 1);
    for (const auto& [word, part] : kParts) {
      if (!format.starts_with(word)) continue;
      pieces_.push_back({part, {}});
      taken = word;
    }
    if (taken.size() == 1) add_text(taken);
    format.remove_prefix(taken.size());
  }
}

void ConsoleFormat::add_text(std::string_view text) {
  if (!text.empty()) pieces_.push_back({Part::kText, unescaped(text)});
}

std::string ConsoleFormat::line(const LogRecord& record, std::int64_t now) const {
  std::string out;
  for (const Piece& piece : pieces_) {
    switch (piece.part) {
      case Part::kText:
        out += piece.text;
        break;
      case Part::kSeverity:
        out += label(record.level);
        break;
      case Part::kName:
        out += record.name;
        break;
      case Part::kMessage:
        out += record.text;
        break;
      case Part::kFunction:
        out += record.where.function_name();
        break;
      case Part::kFile:
        out += record.where.file_name();
        break;
      case Part::kLine:
        out += std::to_string(record.where.line());
        break;
      case Part::kTime:
        out += fmt::format("{}.{:09}", now / 1'000'000'000, now % 1'000'000'000);
        break;
      case Part::kNanoseconds:
        out += std::to_string(now);
        break;
      case Part::kDate:
        out += local_time(now);
        break;
    }
  }
  return out;
}

}  // namespace goalnet::ros
