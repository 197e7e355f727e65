#include "components/goalnet/ranker/boosted_trees.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "components/goalnet/random.h"

namespace goalnet::inference {
namespace {

constexpr std::size_t kBins = 32;

// Each feature cut into at most kBins bins of about equally many rows.
struct Binned {
  std::vector<std::uint8_t> bins;              // row-major
  std::vector<std::vector<float>> thresholds;  // bin b holds values < thresholds[b]; the last bin the rest
};

Binned make_bins(std::span<const float> rows, std::size_t columns, std::size_t count) {
  Binned binned;
  binned.bins.resize(columns * count);
  binned.thresholds.resize(columns);
  std::vector<float> values(count);
  for (std::size_t c = 0; c < columns; ++c) {
    for (std::size_t r = 0; r < count; ++r) values[r] = rows[r * columns + c];
    std::sort(values.begin(), values.end());
    auto& cuts = binned.thresholds[c];
    for (std::size_t b = 1; b < kBins; ++b) {
      const float cut = values[b * count / kBins];
      if ((cuts.empty() || cut > cuts.back()) && cut > values.front()) cuts.push_back(cut);
    }
    for (std::size_t r = 0; r < count; ++r)
      binned.bins[r * columns + c] = static_cast<std::uint8_t>(
          std::upper_bound(cuts.begin(), cuts.end(), rows[r * columns + c]) - cuts.begin());
  }
  return binned;
}

// What is left to learn of the rows in each bin of each column.
struct Cell {
  float sum = 0, count = 0;
};
using Histogram = std::vector<Cell>;  // kBins for each column

Histogram histogram(const Binned& binned, std::size_t columns, const std::vector<std::uint32_t>& rows,
                    const std::vector<float>& residual) {
  Histogram cells(columns * kBins);
  for (const std::uint32_t r : rows) {
    const std::uint8_t* bins = binned.bins.data() + r * columns;
    const float left = residual[r];
    for (std::size_t c = 0; c < columns; ++c) {
      Cell& cell = cells[c * kBins + bins[c]];
      cell.sum += left, cell.count += 1;
    }
  }
  return cells;
}

struct Split {
  float gain = 1e-6f;
  std::size_t column = 0, bin = 0;
};

Split best_split(const Histogram& cells, const Binned& binned, float sum, float n,
                 const BoostOptions& options, const std::vector<bool>& usable) {
  Split best;
  const auto least = static_cast<float>(options.min_rows);
  for (std::size_t c = 0; c < binned.thresholds.size(); ++c) {
    if (!usable[c]) continue;
    float left = 0, left_n = 0;
    for (std::size_t b = 0; b < binned.thresholds[c].size(); ++b) {
      left += cells[c * kBins + b].sum, left_n += cells[c * kBins + b].count;
      const float right = sum - left, right_n = n - left_n;
      if (left_n < least || right_n < least) continue;
      const float gain = left * left / (left_n + options.ridge) + right * right / (right_n + options.ridge) -
                         sum * sum / (n + options.ridge);
      if (gain > best.gain) best = {gain, c, b};
    }
  }
  return best;
}

}  // namespace

BoostedTrees BoostedTrees::train(std::span<const float> rows, std::size_t columns,
                                 std::span<const float> targets, const BoostOptions& options) {
  BoostedTrees model;
  const std::size_t count = targets.size();
  if (count == 0) return model;
  const Binned binned = make_bins(rows, columns, count);
  std::vector<float> residual(targets.begin(), targets.end());
  Random random(options.seed);

  struct Open {
    std::vector<std::uint32_t> rows;
    Histogram cells;
    std::int32_t node;
    int depth;
  };
  std::vector<bool> usable(columns);
  for (int t = 0; t < options.trees; ++t) {
    for (std::size_t c = 0; c < columns; ++c) usable[c] = random.uniform() < options.column_share;
    Open root{{}, {}, static_cast<std::int32_t>(model.nodes_.size()), 0};
    for (std::uint32_t r = 0; r < count; ++r)
      if (random.uniform() < options.row_share) root.rows.push_back(r);
    root.cells = histogram(binned, columns, root.rows, residual);
    model.roots_.push_back(root.node);
    model.nodes_.emplace_back();
    std::vector<Open> open;
    open.push_back(std::move(root));
    while (!open.empty()) {
      Open at = std::move(open.back());
      open.pop_back();
      float sum = 0;
      for (const std::uint32_t r : at.rows) sum += residual[r];
      const float n = static_cast<float>(at.rows.size());
      Split best;
      if (at.depth < options.depth && at.rows.size() >= 2 * options.min_rows)
        best = best_split(at.cells, binned, sum, n, options, usable);
      Node& node = model.nodes_[static_cast<std::size_t>(at.node)];
      if (best.gain <= 1e-6f) {
        node.threshold = options.rate * sum / (n + options.ridge);
        continue;
      }
      node.feature = static_cast<std::int32_t>(best.column);
      node.threshold = binned.thresholds[best.column][best.bin];
      node.left = static_cast<std::int32_t>(model.nodes_.size());
      node.right = node.left + 1;
      Open left{{}, {}, node.left, at.depth + 1}, right{{}, {}, node.right, at.depth + 1};
      for (const std::uint32_t r : at.rows)
        (binned.bins[r * columns + best.column] <= best.bin ? left : right).rows.push_back(r);
      model.nodes_.resize(model.nodes_.size() + 2);
      if (at.depth + 1 < options.depth) {
        // Only the smaller side is counted; the other is what remains.
        Open &small = left.rows.size() < right.rows.size() ? left : right,
             &large = left.rows.size() < right.rows.size() ? right : left;
        small.cells = histogram(binned, columns, small.rows, residual);
        large.cells = std::move(at.cells);
        for (std::size_t i = 0; i < large.cells.size(); ++i)
          large.cells[i].sum -= small.cells[i].sum, large.cells[i].count -= small.cells[i].count;
      }
      open.push_back(std::move(left));
      open.push_back(std::move(right));
    }
    const std::int32_t first = model.roots_.back();
    for (std::size_t r = 0; r < count; ++r) {
      std::int32_t i = first;
      while (model.nodes_[static_cast<std::size_t>(i)].feature >= 0) {
        const Node& node = model.nodes_[static_cast<std::size_t>(i)];
        i = rows[r * columns + static_cast<std::size_t>(node.feature)] < node.threshold ? node.left
                                                                                        : node.right;
      }
      residual[r] -= model.nodes_[static_cast<std::size_t>(i)].threshold;
    }
  }
  return model;
}

BoostedTrees BoostedTrees::train_bag(std::span<const float> rows, std::size_t columns,
                                     std::span<const float> targets, BoostOptions options, int bag) {
  BoostedTrees all;
  for (int i = 0; i < bag; ++i, ++options.seed) {
    const BoostedTrees one = train(rows, columns, targets, options);
    const auto base = static_cast<std::int32_t>(all.nodes_.size());
    for (Node node : one.nodes_) {
      if (node.feature >= 0)
        node.left += base, node.right += base;
      else
        node.threshold /= static_cast<float>(bag);
      all.nodes_.push_back(node);
    }
    for (const std::int32_t root : one.roots_) all.roots_.push_back(root + base);
  }
  return all;
}

std::vector<float> BoostedTrees::predict(std::span<const float> rows, std::size_t columns) const {
  std::vector<float> sums(rows.size() / columns, 0.0f);
  std::vector<std::int32_t> at(sums.size());
  // Tree by tree: a tree fits into the processor's nearest memory, all of them do not. All rows take one step
  // before any takes the next, and without a branch on the way to go: no row waits for another.
  for (const std::int32_t root : roots_) {
    std::fill(at.begin(), at.end(), root);
    for (bool all_done = false; !all_done;) {
      all_done = true;
      for (std::size_t r = 0; r < sums.size(); ++r) {
        const Node& node = nodes_[static_cast<std::size_t>(at[r])];
        if (node.feature < 0) continue;
        const bool left = rows[r * columns + static_cast<std::size_t>(node.feature)] < node.threshold;
        at[r] = node.right ^ ((node.left ^ node.right) & -static_cast<std::int32_t>(left));
        all_done = false;
      }
    }
    for (std::size_t r = 0; r < sums.size(); ++r)
      sums[r] += nodes_[static_cast<std::size_t>(at[r])].threshold;
  }
  return sums;
}

bool BoostedTrees::assign(std::vector<Node> nodes, std::vector<std::int32_t> roots, std::size_t columns) {
  const auto size = static_cast<std::int32_t>(nodes.size());
  for (std::int32_t i = 0; i < size; ++i) {
    const Node& node = nodes[static_cast<std::size_t>(i)];
    if (node.feature < 0) continue;
    if (node.feature >= static_cast<std::int32_t>(columns) || node.left <= i || node.right <= i ||
        node.left >= size || node.right >= size)
      return false;
  }
  for (const std::int32_t root : roots)
    if (root < 0 || root >= size) return false;
  nodes_ = std::move(nodes);
  roots_ = std::move(roots);
  return true;
}

}  // namespace goalnet::inference
