#include "components/goalnet/training/torch_encoding.h"

#include <algorithm>

namespace goalnet::inference::training {

using network::SentenceEncoding;
using network::TemporalContext;
using torch::Tensor;

namespace {

Tensor indices(const std::vector<std::int64_t>& values) { return torch::tensor(values, torch::kInt64); }

Tensor lstm(const Tensor& input, const Tensor& in, const Tensor& hidden, const Tensor& bias,
            const Tensor& state, Tensor& memory) {
  const auto g = (torch::matmul(input, in.t()) + torch::matmul(state, hidden.t()) + bias).chunk(4, 1);
  memory = torch::sigmoid(g[1]) * memory + torch::sigmoid(g[0]) * torch::tanh(g[2]);
  return torch::sigmoid(g[3]) * torch::tanh(memory);
}

}  // namespace

Tensor gru(const Tensor& gates_in, const Tensor& hidden, const Tensor& hidden_bias, const Tensor& state) {
  const auto in = gates_in.chunk(3, 1);
  const auto own = (torch::matmul(state, hidden.t()) + hidden_bias).chunk(3, 1);
  const Tensor reset = torch::sigmoid(in[0] + own[0]), update = torch::sigmoid(in[1] + own[1]);
  const Tensor fresh = torch::tanh(in[2] + reset * own[2]);
  return fresh + update * (state - fresh);
}

TorchEncoding::TorchEncoding(const network::NetworkConfig& config, const Tensors& tensors,
                             const network::NameTable& names, std::span<const EncodedEpisode* const> episodes,
                             double dropout)
    : config_(config), tensors_(tensors), episodes_(episodes), dropout_(dropout) {
  for (std::size_t e = 0; e < episodes.size(); ++e) {
    words_ =
        std::max(words_, std::max<std::int64_t>(1, static_cast<std::int64_t>(episodes[e]->words.size())));
    longest_ = std::max(longest_, static_cast<std::int64_t>(episodes[e]->steps.size()));
    for (const StepExample& step : episodes[e]->steps) {
      steps_.push_back(&step);
      episode_of_.push_back(static_cast<std::int64_t>(e));
      objects_ = std::max(objects_, static_cast<std::int64_t>(step.world.objects));
    }
  }
  encode_names(names);
  encode_sentences();
  step_sentence_ = sentence_.index_select(0, indices(episode_of_));
  encode_objects();
  context_ = attend(w("attention.objects"), mask_);
  goal_objects_ = torch::zeros_like(context_);
  if (config_.goal_object_attention) {
    const Tensor any = mentioned_.any(1, true);
    goal_objects_ = attend(w("attention.goal_objects"), mentioned_) * any.to(torch::kFloat);
  }
  encode_history();
  Tensor words = step_sentence_;
  if (config_.instruction_attention) {
    const Tensor query = torch::matmul(history_, w("attention.words").t()).unsqueeze(2);
    const Tensor tokens = tokens_.index_select(0, indices(episode_of_));
    Tensor scores = torch::bmm(tokens, query).squeeze(2);
    scores = scores.masked_fill(token_mask_.index_select(0, indices(episode_of_)).logical_not(), -1e9);
    words = torch::bmm(torch::softmax(scores, 1).unsqueeze(1), tokens).squeeze(1);
  }
  const Tensor in = torch::cat({context_, goal_objects_, step_sentence_, words, history_}, 1);
  start_ = torch::tanh(torch::matmul(drop(in), w("start.in").t()) + w("start.bias"));
}

Tensor TorchEncoding::drop(const Tensor& tensor) const {
  return dropout_ > 0 ? torch::dropout(tensor, dropout_, true) : tensor;
}

void TorchEncoding::encode_names(const network::NameTable& names) {
  const auto slots = static_cast<std::int64_t>(names.size());
  Tensor mean = torch::zeros({slots, w("words.vectors").size(0)});
  auto place = mean.accessor<float, 2>();
  for (std::int64_t slot = 0; slot < slots; ++slot) {
    const auto& words = names.entry(static_cast<int>(slot)).words;
    for (const int word : words) place[slot][word] += 1.0F / static_cast<float>(words.size());
  }
  name_vectors_ = torch::matmul(mean, w("words.vectors") + w("words.learned"));
}

Tensor TorchEncoding::read_direction(const Tensor& inputs, const Tensor& known, bool forward) const {
  const std::string prefix = forward ? "sentence.forward." : "sentence.backward.";
  const Tensor& hidden = tensors_.at(prefix + "hidden");
  const Tensor& hidden_bias = tensors_.at(prefix + "hidden_bias");
  const Tensor gates =
      torch::matmul(inputs, tensors_.at(prefix + "in").t()) + tensors_.at(prefix + "in_bias");
  Tensor state = torch::zeros({inputs.size(0), config_.sentence});
  std::vector<Tensor> states(static_cast<std::size_t>(words_));
  for (std::int64_t k = 0; k < words_; ++k) {
    const std::int64_t i = forward ? k : words_ - 1 - k;
    const Tensor next = gru(gates.select(1, i), hidden, hidden_bias, state);
    state = torch::where(known.select(1, i).unsqueeze(1), next, state);
    states[static_cast<std::size_t>(i)] = state;
  }
  return torch::stack(states, 1);
}

void TorchEncoding::encode_sentences() {
  const auto count = static_cast<std::int64_t>(episodes_.size());
  if (config_.encoding == SentenceEncoding::kExternal) {
    Tensor vectors = torch::zeros({count, config_.external});
    for (std::int64_t e = 0; e < count; ++e)
      vectors[e] = torch::tensor(episodes_[static_cast<std::size_t>(e)]->external);
    sentence_ = torch::tanh(torch::matmul(vectors, w("sentence.in").t()) + w("sentence.in_bias"));
    tokens_ = sentence_.unsqueeze(1);
    token_mask_ = torch::ones({count, 1}, torch::kBool);
    return;
  }
  std::vector<std::int64_t> ids(static_cast<std::size_t>(count * words_), 0);
  Tensor inside = torch::zeros({count, words_}, torch::kBool), known = torch::zeros({count, words_, 1});
  for (std::int64_t e = 0; e < count; ++e) {
    const std::vector<int>& words = episodes_[static_cast<std::size_t>(e)]->words;
    for (std::size_t i = 0; i < words.size(); ++i) {
      inside[e][static_cast<std::int64_t>(i)] = true;
      if (words[i] < 0) continue;
      known[e][static_cast<std::int64_t>(i)] = 1.0;
      ids[static_cast<std::size_t>(e * words_) + i] = words[i];
    }
  }
  const Tensor flat = indices(ids);
  Tensor learned = w("words.learned").index_select(0, flat).reshape({count, words_, -1});
  // Words lose what was learned of them now and then, so that the stored vectors alone must do: as for new
  // words.
  if (dropout_ > 0) learned = learned * torch::bernoulli(torch::full({count, words_, 1}, 1 - dropout_));
  Tensor inputs = w("words.vectors").index_select(0, flat).reshape({count, words_, -1}) + learned;
  inputs = drop(inputs) * known;
  token_mask_ = inside;
  const Tensor weight = inside.to(torch::kFloat).unsqueeze(2);
  if (config_.encoding == SentenceEncoding::kWordMean) {
    tokens_ = torch::tanh(torch::matmul(inputs, w("sentence.in").t()) + w("sentence.in_bias")) * weight;
    sentence_ = tokens_.sum(1) / weight.sum(1);
    return;
  }
  tokens_ =
      torch::cat({read_direction(inputs, inside, true), read_direction(inputs, inside, false)}, 2) * weight;
  if (config_.instruction_attention) {
    const Tensor scores =
        torch::matmul(tokens_, w("sentence.pool")[0]).masked_fill(inside.logical_not(), -1e9);
    sentence_ = torch::bmm(torch::softmax(scores, 1).unsqueeze(1), tokens_).squeeze(1);
  } else {
    sentence_ = tokens_.sum(1) / weight.sum(1);
  }
}

void TorchEncoding::encode_objects() {
  const auto count = static_cast<std::int64_t>(steps_.size());
  Tensor features = torch::zeros({count, objects_, w("object.feature").size(0)});
  mask_ = torch::zeros({count, objects_}, torch::kBool);
  mentioned_ = torch::zeros({count, objects_}, torch::kBool);
  auto place = features.accessor<float, 3>();
  auto inside = mask_.accessor<bool, 2>();
  auto mentioned = mentioned_.accessor<bool, 2>();
  std::vector<std::int64_t> slots(static_cast<std::size_t>(count * objects_), 0), from, to, type;
  for (std::int64_t s = 0; s < count; ++s) {
    const network::EncodedWorld& world = steps_[static_cast<std::size_t>(s)]->world;
    for (int i = 0; i < world.objects; ++i) {
      inside[s][i] = true;
      mentioned[s][i] = world.mentioned[static_cast<std::size_t>(i)] != 0;
      slots[static_cast<std::size_t>(s * objects_ + i)] = world.slot[static_cast<std::size_t>(i)];
      for (const network::FeatureItem& item : world.items_of(i)) place[s][i][item.feature] += item.value;
    }
    for (const network::RelationEdge& edge : world.edges) {
      from.push_back(s * objects_ + edge.from);
      to.push_back(s * objects_ + edge.to);
      type.push_back(edge.type);
    }
  }
  const Tensor names = torch::matmul(name_vectors_, w("object.name").t())
                           .index_select(0, indices(slots))
                           .reshape({count, objects_, -1});
  const Tensor shared = torch::matmul(step_sentence_, w("object.sentence").t()) + w("object.bias");
  raw_ = torch::relu(names + torch::matmul(features, w("object.feature")) + shared.unsqueeze(1));
  if (!config_.relations) {
    encoded_ = raw_;
    return;
  }
  const auto mixed =
      torch::matmul(raw_, w("graph.self_message").t()).reshape({count * objects_, -1}).chunk(2, 1);
  Tensor sum = mixed[0] + w("graph.bias");
  if (!from.empty()) {
    const Tensor messages =
        mixed[1].index_select(0, indices(from)) * w("graph.relation").index_select(0, indices(type));
    sum = sum.index_add(0, indices(to), messages);
  }
  encoded_ = torch::relu(sum).reshape({count, objects_, -1}) + raw_;
}

Tensor TorchEncoding::attend(const Tensor& weights, const Tensor& mask) const {
  Tensor scores = torch::zeros({encoded_.size(0), objects_});
  if (config_.instruction_attention) {
    scores = torch::bmm(encoded_, torch::matmul(step_sentence_, weights.t()).unsqueeze(2)).squeeze(2);
  }
  scores = scores.masked_fill(mask.logical_not(), -1e9);
  return torch::bmm(torch::softmax(scores, 1).unsqueeze(1), encoded_).squeeze(1);
}

void TorchEncoding::encode_history() {
  const auto count = static_cast<std::int64_t>(episodes_.size());
  const std::int64_t h = config_.history;
  history_ = torch::zeros({static_cast<std::int64_t>(steps_.size()), h});
  if (config_.temporal == TemporalContext::kNone) return;
  const bool of_states = config_.temporal == TemporalContext::kState;
  const std::int64_t reads = of_states ? longest_ : longest_ - 1;
  std::vector<std::int64_t> where;  // by step: its place in the stacked states
  std::vector<Tensor> states = {torch::zeros({count, h})};
  Tensor memory = torch::zeros({count, h});
  Tensor inputs = torch::zeros({std::max<std::int64_t>(1, reads) * count, h});  // time-major
  if (of_states) {
    std::vector<std::int64_t> step, row;
    std::int64_t next = 0;
    for (std::int64_t e = 0; e < count; ++e) {
      for (std::size_t t = 0; t < episodes_[static_cast<std::size_t>(e)]->steps.size(); ++t) {
        step.push_back(next++);
        row.push_back(static_cast<std::int64_t>(t) * count + e);
      }
    }
    inputs = inputs.index_add(0, indices(row),
                              torch::matmul(context_.index_select(0, indices(step)), w("past.state").t()));
  } else {
    const Tensor mains = torch::matmul(name_vectors_, w("past.main").t()),
                 seconds = torch::matmul(name_vectors_, w("past.second").t());
    std::vector<std::int64_t> row, token, main, pair_row, pair, value_row, value;
    for (std::int64_t e = 0; e < count; ++e) {
      const auto& past = episodes_[static_cast<std::size_t>(e)]->past;
      for (std::size_t g = 0; g < past.size(); ++g) {
        for (const network::PastPredicate& p : past[g]) {
          if (config_.temporal == TemporalContext::kPositive && !network::is_positive_token(p.token))
            continue;
          const std::int64_t at = static_cast<std::int64_t>(g) * count + e;
          row.push_back(at);
          token.push_back(p.token);
          main.push_back(p.main_slot);
          if (p.second_slot >= 0) pair_row.push_back(at), pair.push_back(p.second_slot);
          if (p.value >= 0) value_row.push_back(at), value.push_back(p.value);
        }
      }
    }
    if (!row.empty()) {
      inputs = inputs.index_add(
          0, indices(row),
          w("past.token").index_select(0, indices(token)) + mains.index_select(0, indices(main)));
    }
    if (!pair.empty())
      inputs = inputs.index_add(0, indices(pair_row), seconds.index_select(0, indices(pair)));
    if (!value.empty())
      inputs = inputs.index_add(0, indices(value_row), w("past.value").index_select(0, indices(value)));
  }
  for (std::int64_t t = 0; t < reads; ++t) {
    states.push_back(lstm(inputs.slice(0, t * count, (t + 1) * count), w("lstm.in"), w("lstm.hidden"),
                          w("lstm.bias"), states.back(), memory));
  }
  for (std::int64_t e = 0; e < count; ++e) {
    for (std::size_t t = 0; t < episodes_[static_cast<std::size_t>(e)]->steps.size(); ++t) {
      where.push_back((static_cast<std::int64_t>(t) + (of_states ? 1 : 0)) * count + e);
    }
  }
  history_ = torch::cat(states, 0).index_select(0, indices(where));
}

}  // namespace goalnet::inference::training
