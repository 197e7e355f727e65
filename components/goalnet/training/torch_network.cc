#include "components/goalnet/training/torch_network.h"

#include <cmath>

#include "components/goalnet/training/torch_encoding.h"

namespace goalnet::inference::training {

using torch::Tensor;
namespace F = torch::nn::functional;

TorchNetwork::TorchNetwork(const network::NetworkConfig& config, const Vocabulary& vocabulary,
                           std::uint64_t seed)
    : config_(config), sizes_(network::sizes_of(vocabulary.lexicon, vocabulary.grammar)) {
  torch::manual_seed(seed);
  for (const network::TensorShape& shape : network::tensor_shapes(config, sizes_)) {
    Tensor tensor = torch::zeros({shape.rows, shape.cols});
    const bool is_bias = shape.name.find("bias") != std::string::npos;
    if (shape.name == "words.vectors") {
      std::memcpy(tensor.data_ptr<float>(), vocabulary.vectors.data(),
                  sizeof(float) * static_cast<std::size_t>(vocabulary.vectors.size()));
    } else if (shape.name != "words.learned" && !is_bias) {
      // Rows that are looked up rather than multiplied start small; the others as Xavier has it.
      const bool looked_up = shape.name == "object.feature" || shape.name.ends_with("_in") ||
                             shape.name.starts_with("past.") || shape.name == "graph.relation";
      const double scale = looked_up ? 0.3 / std::sqrt(3.0) : std::sqrt(6.0 / (shape.rows + shape.cols));
      tensor.uniform_(-scale, scale);
    }
    if (shape.name == "graph.relation") tensor += 1;
    if (shape.name != "words.vectors") {
      tensor.set_requires_grad(true);
      parameters_.emplace_back(shape.name, tensor);
    }
    tensors_[shape.name] = tensor;
  }
}

namespace {

// Cross entropy of chosen rows; counts into `right` (by step) what was not the most probable.
struct Judge {
  Tensor total = torch::zeros({});
  std::vector<bool> wrong;

  void add(const Tensor& logits, const std::vector<std::int64_t>& wanted,
           const std::vector<std::int64_t>& steps) {
    if (wanted.empty()) return;
    const Tensor target = torch::tensor(wanted);
    total = total + F::cross_entropy(logits, target, F::CrossEntropyFuncOptions().reduction(torch::kSum));
    const Tensor best = logits.detach().argmax(1);
    const auto* data = best.data_ptr<std::int64_t>();
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (data[i] != wanted[i]) wrong[static_cast<std::size_t>(steps[i])] = true;
    }
  }
};

void keep(std::vector<DecisionScores>* record, const std::vector<std::int64_t>& steps, const Tensor& logits,
          const std::vector<int>& sizes) {
  if (record == nullptr) return;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Tensor row = logits[static_cast<std::int64_t>(i)].detach().contiguous();
    const float* data = row.data_ptr<float>();
    (*record)[static_cast<std::size_t>(steps[i])].scores.emplace_back(data, data + sizes[i]);
  }
}

}  // namespace

LossReport TorchNetwork::run(std::span<const EncodedEpisode* const> episodes, const network::NameTable& names,
                             double dropout, std::vector<DecisionScores>* record) const {
  const TorchEncoding encoding(config_, tensors_, names, episodes, dropout);
  const auto w = [this](const char* name) -> const Tensor& { return tensors_.at(name); };
  const std::int64_t n = encoding.max_objects(), o = config_.object;
  const Tensor encoded = encoding.objects();  // steps x n x object
  const Tensor object_mask = encoding.object_mask();
  const Tensor main_keys = torch::matmul(encoded, w("decoder.main_key").t());
  const Tensor second_keys = torch::matmul(encoded, w("decoder.second_key").t());
  const std::vector<const StepExample*>& steps = encoding.steps();

  std::vector<std::int64_t> active;  // steps still decoding
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!steps[i]->targets.empty()) active.push_back(static_cast<std::int64_t>(i));
  }
  Judge judge;
  judge.wrong.resize(steps.size());
  const int decoded = static_cast<int>(active.size());
  Tensor state = encoding.start().index_select(0, torch::tensor(active));
  Tensor input = w("decoder.token_in")[network::kStopToken].expand({decoded, o});

  const auto rows_of = [&](const Tensor& all, const std::vector<std::int64_t>& which) {
    return all.index_select(0, torch::tensor(which));
  };
  const auto object_at = [&](const std::vector<std::int64_t>& step, const std::vector<std::int64_t>& object) {
    std::vector<std::int64_t> flat;
    for (std::size_t i = 0; i < step.size(); ++i) flat.push_back(step[i] * n + object[i]);
    return encoded.reshape({-1, o}).index_select(0, torch::tensor(flat));
  };
  const auto pointer = [&](const Tensor& keys, const Tensor& query, const Tensor& out,
                           const std::vector<std::int64_t>& which) {
    const Tensor hidden = torch::relu(rows_of(keys, which) + query.unsqueeze(1));
    return torch::matmul(hidden, out[0]).masked_fill(rows_of(object_mask, which).logical_not(), -1e9);
  };

  for (std::size_t k = 0; !active.empty(); ++k) {
    state = gru(torch::matmul(input, w("decoder.in").t()) + w("decoder.in_bias"), w("decoder.hidden"),
                w("decoder.hidden_bias"), state);
    const Tensor tokens = torch::matmul(state, w("decoder.token").t()) + w("decoder.token_bias");
    std::vector<std::int64_t> wanted, next, next_row;
    for (std::size_t i = 0; i < active.size(); ++i) {
      const Target& target = steps[static_cast<std::size_t>(active[i])]->targets[k];
      wanted.push_back(target.token);
      if (target.token == network::kStopToken) continue;
      next.push_back(active[i]);
      next_row.push_back(static_cast<std::int64_t>(i));
    }
    judge.add(tokens, wanted, active);
    keep(record, active, tokens, std::vector<int>(active.size(), network::kTokens));
    if (next.empty()) break;
    state = rows_of(state, next_row);
    std::vector<std::int64_t> token, main, pair_row, pair_step, pair_main, pair_wanted, value_row, value_step,
        value_wanted;
    std::vector<int> sizes, pair_sizes;
    for (std::size_t i = 0; i < next.size(); ++i) {
      const StepExample& step = *steps[static_cast<std::size_t>(next[i])];
      const Target& target = step.targets[k];
      token.push_back(target.token);
      main.push_back(target.main);
      sizes.push_back(step.world.objects);
      if (target.second >= 0) {
        pair_row.push_back(static_cast<std::int64_t>(i));
        pair_step.push_back(next[i]);
        pair_main.push_back(target.main);
        pair_wanted.push_back(target.second);
        pair_sizes.push_back(step.world.objects);
      }
      if (target.value >= 0) {
        value_row.push_back(static_cast<std::int64_t>(i));
        value_step.push_back(next[i]);
        value_wanted.push_back(target.value);
      }
    }
    const Tensor token_in = w("decoder.token_in").index_select(0, torch::tensor(token));
    const Tensor with_token = torch::cat({state, token_in}, 1);
    const Tensor query =
        torch::matmul(with_token, w("decoder.main_query").t()) + w("decoder.main_query_bias");
    const Tensor mains = pointer(main_keys, query, w("decoder.main_out"), next);
    judge.add(mains, main, next);
    keep(record, next, mains, sizes);
    const Tensor main_in = object_at(next, main);
    const Tensor with_main = torch::cat({with_token, main_in}, 1);
    input = token_in + torch::matmul(main_in, w("decoder.main_in").t());
    if (!pair_row.empty()) {
      const Tensor pair_query = torch::matmul(rows_of(with_main, pair_row), w("decoder.second_query").t()) +
                                w("decoder.second_query_bias");
      const Tensor seconds = pointer(second_keys, pair_query, w("decoder.second_out"), pair_step);
      judge.add(seconds, pair_wanted, pair_step);
      keep(record, pair_step, seconds, pair_sizes);
      const Tensor second_in = torch::matmul(object_at(pair_step, pair_wanted), w("decoder.second_in").t());
      input = input.index_add(0, torch::tensor(pair_row), second_in);
    }
    if (!value_row.empty()) {
      const Tensor values =
          torch::matmul(rows_of(with_main, value_row), w("decoder.value").t()) + w("decoder.value_bias");
      judge.add(values, value_wanted, value_step);
      keep(record, value_step, values, std::vector<int>(value_step.size(), sizes_.values));
      input = input.index_add(0, torch::tensor(value_row),
                              w("decoder.value_in").index_select(0, torch::tensor(value_wanted)));
    }
    active = next;
  }
  LossReport report;
  report.steps = decoded;
  report.loss = judge.total / std::max(1, decoded);
  for (std::size_t i = 0; i < steps.size(); ++i)
    report.right += !steps[i]->targets.empty() && !judge.wrong[i];
  return report;
}

LossReport TorchNetwork::loss(std::span<const EncodedEpisode* const> episodes,
                              const network::NameTable& names, double dropout) const {
  return run(episodes, names, dropout, nullptr);
}

std::vector<DecisionScores> TorchNetwork::scores(const EncodedEpisode& episode,
                                                 const network::NameTable& names) const {
  torch::NoGradGuard no_gradients;
  std::vector<DecisionScores> record(episode.steps.size());
  const EncodedEpisode* one[] = {&episode};
  run(one, names, 0, &record);
  return record;
}

}  // namespace goalnet::inference::training
