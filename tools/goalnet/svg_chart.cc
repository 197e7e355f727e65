#include "tools/goalnet/svg_chart.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace goalnet::tools {
namespace {

constexpr double kWidth = 860, kHeight = 420, kLeft = 60, kRight = 240, kTop = 40, kBottom = 50;
constexpr std::array<const char*, 10> kColours = {"#1f77b4", "#d62728", "#2ca02c", "#ff7f0e", "#9467bd",
                                                  "#8c564b", "#e377c2", "#7f7f7f", "#bcbd22", "#17becf"};

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '&') {
      result += "&amp;";
    } else {
      result.push_back(c);
    }
  }
  return result;
}

std::string label(double x, double y, const std::string& text, const char* anchor, const char* more = "") {
  char position[80];
  std::snprintf(position, sizeof position, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" %s>", x, y, anchor,
                more);
  return position + escaped(text) + "</text>\n";
}

std::string segment(double x1, double y1, double x2, double y2, const char* colour, double width) {
  char text[160];
  std::snprintf(
      text, sizeof text,
      "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" stroke-width=\"%.1f\"/>\n", x1, y1,
      x2, y2, colour, width);
  return text;
}

// 1, 2 or 5 times a power of ten, so that about five steps fill the range.
double nice_step(double range) {
  double step = 1;
  while (step * 5 > range) step /= 10;
  while (step * 50 < range) step *= 10;
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    if (step * factor * 6 >= range) return step * factor;
  }
  return step * 10;
}

}  // namespace

std::string to_svg(const Chart& chart) {
  double x_min = 1e300, x_max = -1e300;
  for (const ChartLine& line : chart.lines) {
    for (const auto& [x, y] : line.points) {
      x_min = std::min(x_min, x);
      x_max = std::max(x_max, x);
    }
  }
  if (x_min > x_max) x_min = 0, x_max = 1;
  if (x_max - x_min < 1e-9) x_max = x_min + 1;
  const double plot_width = kWidth - kLeft - kRight, plot_height = kHeight - kTop - kBottom;
  const auto px = [&](double x) { return kLeft + (x - x_min) / (x_max - x_min) * plot_width; };
  const auto py = [&](double y) {
    return kTop +
           (1 - (std::clamp(y, chart.y_min, chart.y_max) - chart.y_min) / (chart.y_max - chart.y_min)) *
               plot_height;
  };
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(kWidth) + " " +
                    number(kHeight) +
                    "\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
                    "fill=\"white\"/>\n";
  svg += label(kLeft, 22, chart.title, "start", "font-size=\"15\"");
  const double x_step = nice_step(x_max - x_min), y_step = nice_step(chart.y_max - chart.y_min);
  for (double y = chart.y_min; y <= chart.y_max + y_step / 1000; y += y_step) {
    svg += segment(kLeft, py(y), kLeft + plot_width, py(y), "#dddddd", 1) +
           label(kLeft - 6, py(y) + 4, number(y), "end");
  }
  for (double x = x_min; x <= x_max + x_step / 1000; x += x_step)
    svg += label(px(x), kTop + plot_height + 18, number(x), "middle");
  svg += segment(kLeft, kTop + plot_height, kLeft + plot_width, kTop + plot_height, "black", 1);
  svg += segment(kLeft, kTop, kLeft, kTop + plot_height, "black", 1);
  svg += label(kLeft + plot_width / 2, kHeight - 10, chart.x_label, "middle");
  svg += label(kLeft + 4, kTop - 4, chart.y_label, "start");
  for (std::size_t i = 0; i < chart.lines.size(); ++i) {
    const ChartLine& line = chart.lines[i];
    const char* colour = kColours[i % kColours.size()];
    const char* dash = i < kColours.size() ? "" : " stroke-dasharray=\"5,3\"";
    svg += "<polyline fill=\"none\" stroke=\"" + std::string(colour) + "\" stroke-width=\"" +
           (line.strong ? "3" : "1.5") + "\"" + dash + " points=\"";
    for (const auto& [x, y] : line.points) {
      char point[48];
      std::snprintf(point, sizeof point, "%.1f,%.1f ", px(x), py(y));
      svg += point;
    }
    svg += "\"/>\n";
    const double y = kTop + 14 + 18 * static_cast<double>(i);
    svg += segment(kLeft + plot_width + 14, y - 4, kLeft + plot_width + 34, y - 4, colour,
                   line.strong ? 3 : 1.5);
    svg += label(kLeft + plot_width + 40, y, line.name, "start");
  }
  return svg + "</svg>\n";
}

}  // namespace goalnet::tools
