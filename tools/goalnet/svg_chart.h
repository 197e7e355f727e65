// Line charts as SVG text: axes, grid, legend. For docs/benchmark.md; no drawing library needed.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace goalnet::tools {

struct ChartLine {
  std::string name;
  std::vector<std::pair<double, double>> points;  // x, y; x rising
  bool strong = false;                            // drawn thicker
};

struct Chart {
  std::string title, x_label, y_label;
  std::vector<ChartLine> lines;
  double y_min = 0, y_max = 1;
};

// The same chart gives the same text.
std::string to_svg(const Chart& chart);

}  // namespace goalnet::tools
