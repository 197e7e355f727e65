// Gradient-boosted regression trees (squared loss, histograms): small, deterministic, quick to evaluate.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace goalnet::inference {

struct BoostOptions {
  int trees = 200;
  int depth = 4;
  float rate = 0.05f;
  std::size_t min_rows = 60;  // in a leaf
  float row_share = 0.7f;     // of the rows that a tree sees
  float column_share = 0.5f;  // of the columns that a tree may split by
  float ridge = 5.0f;         // shrinks leaves with few rows
  std::uint64_t seed = 1;
};

class BoostedTrees {
 public:
  // One node of a tree: goes left where feature < threshold. A leaf has feature -1 and its value in
  // threshold.
  struct Node {
    std::int32_t feature = -1;
    float threshold = 0;
    std::int32_t left = 0, right = 0;  // indices into nodes()
  };

  // `rows`: row-major, `columns` features each; `targets`: one for each row.
  static BoostedTrees train(std::span<const float> rows, std::size_t columns, std::span<const float> targets,
                            const BoostOptions& options);

  // Trained as often as said with different seeds: their mean errs less than any one of them.
  static BoostedTrees train_bag(std::span<const float> rows, std::size_t columns,
                                std::span<const float> targets, BoostOptions options, int bag);

  float predict(std::span<const float> row) const { return predict(row, row.size()).front(); }
  // `rows` as for train(); one prediction for each row.
  std::vector<float> predict(std::span<const float> rows, std::size_t columns) const;
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<std::int32_t>& roots() const { return roots_; }
  // From a file. False when an index points outside or backwards (trees would not end).
  bool assign(std::vector<Node> nodes, std::vector<std::int32_t> roots, std::size_t columns);
  bool empty() const { return roots_.empty(); }

 private:
  std::vector<Node> nodes_;
  std::vector<std::int32_t> roots_;
};

}  // namespace goalnet::inference
