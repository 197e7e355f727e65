// The Eigen transformer equals the same transformer written with libtorch's own layers, on small random
// weights.
#include <gtest/gtest.h>
#include <torch/torch.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "components/goalnet/encoder/bert_encoder.h"

namespace goalnet::inference {
namespace {

namespace F = torch::nn::functional;
using torch::Tensor;

constexpr int kVocabulary = 12, kHidden = 24, kInner = 40, kHeads = 3, kLayers = 2, kPositions = 16;

std::map<std::string, Tensor> random_weights() {
  torch::manual_seed(3);
  std::map<std::string, Tensor> w;
  const auto add = [&w](const std::string& name, std::vector<std::int64_t> shape, double around) {
    w[name] = torch::randn(shape) * 0.3 + around;
  };
  add("embeddings.word_embeddings.weight", {kVocabulary, kHidden}, 0);
  add("embeddings.position_embeddings.weight", {kPositions, kHidden}, 0);
  add("embeddings.token_type_embeddings.weight", {2, kHidden}, 0);
  const auto norm = [&](const std::string& name) {
    add(name + ".weight", {kHidden}, 1);
    add(name + ".bias", {kHidden}, 0);
  };
  const auto dense = [&](const std::string& name, int out, int in) {
    add(name + ".weight", {out, in}, 0);
    add(name + ".bias", {out}, 0);
  };
  norm("embeddings.LayerNorm");
  for (int i = 0; i < kLayers; ++i) {
    const std::string layer = "encoder.layer." + std::to_string(i) + ".";
    for (const char* part : {"query", "key", "value"})
      dense(layer + "attention.self." + part, kHidden, kHidden);
    dense(layer + "attention.output.dense", kHidden, kHidden);
    norm(layer + "attention.output.LayerNorm");
    dense(layer + "intermediate.dense", kInner, kHidden);
    dense(layer + "output.dense", kHidden, kInner);
    norm(layer + "output.LayerNorm");
  }
  return w;
}

// torch's MultiheadAttention, layer_norm, linear and gelu with the same weights.
Tensor reference(const std::map<std::string, Tensor>& w, const std::vector<std::int64_t>& ids) {
  torch::NoGradGuard no_gradients;
  const auto norm = [&](const std::string& name, const Tensor& x) {
    return F::layer_norm(x, F::LayerNormFuncOptions({kHidden})
                                .weight(w.at(name + ".weight"))
                                .bias(w.at(name + ".bias"))
                                .eps(1e-12));
  };
  const auto dense = [&](const std::string& name, const Tensor& x) {
    return F::linear(x, w.at(name + ".weight"), w.at(name + ".bias"));
  };
  const auto length = static_cast<std::int64_t>(ids.size());
  Tensor x = w.at("embeddings.word_embeddings.weight").index_select(0, torch::tensor(ids)) +
             w.at("embeddings.position_embeddings.weight").slice(0, 0, length) +
             w.at("embeddings.token_type_embeddings.weight")[0];
  x = norm("embeddings.LayerNorm", x);
  for (int i = 0; i < kLayers; ++i) {
    const std::string layer = "encoder.layer." + std::to_string(i) + ".", self = layer + "attention.self.";
    torch::nn::MultiheadAttention attention(torch::nn::MultiheadAttentionOptions(kHidden, kHeads));
    attention->in_proj_weight.copy_(
        torch::cat({w.at(self + "query.weight"), w.at(self + "key.weight"), w.at(self + "value.weight")}));
    attention->in_proj_bias.copy_(
        torch::cat({w.at(self + "query.bias"), w.at(self + "key.bias"), w.at(self + "value.bias")}));
    attention->out_proj->weight.copy_(w.at(layer + "attention.output.dense.weight"));
    attention->out_proj->bias.copy_(w.at(layer + "attention.output.dense.bias"));
    const Tensor in = x.unsqueeze(1);
    const Tensor attended = std::get<0>(attention->forward(in, in, in)).squeeze(1);
    x = norm(layer + "attention.output.LayerNorm", x + attended);
    x = norm(layer + "output.LayerNorm",
             x + dense(layer + "output.dense", F::gelu(dense(layer + "intermediate.dense", x))));
  }
  return x;
}

std::vector<std::byte> file_of(const std::map<std::string, Tensor>& weights, const std::string& prefix) {
  SafeTensorsWriter writer;
  for (const auto& [name, tensor] : weights) {
    std::vector<std::uint64_t> shape;
    for (const std::int64_t size : tensor.sizes()) shape.push_back(static_cast<std::uint64_t>(size));
    const Tensor flat = tensor.contiguous();
    EXPECT_TRUE(
        writer.add(prefix + name, shape, {flat.data_ptr<float>(), static_cast<std::size_t>(flat.numel())}));
  }
  return writer.bytes();
}

const char* kVocab = "[PAD]\n[UNK]\n[CLS]\n[SEP]\nfill\nmug\nwith\nwater\n##s\nthe\nput\nsink\n";

TEST(BertEquality, HiddenStatesOfEveryPiece) {
  torch::set_num_threads(1);
  const auto weights = random_weights();
  for (const char* prefix : {"", "bert."}) {
    const auto file = SafeTensors::parse(file_of(weights, prefix), "random");
    ASSERT_TRUE(file);
    auto loaded = load_bert_weights(*file, R"({"num_attention_heads": 3})");
    ASSERT_TRUE(loaded) << loaded.error().message;
    BertEncoder encoder(std::move(*loaded), *WordPiece::parse(kVocab, "vocab"), "random");
    for (const std::vector<int>& ids :
         {std::vector<int>{2, 3}, {2, 4, 5, 6, 7, 3}, {2, 10, 9, 5, 8, 1, 9, 11, 4, 4, 4, 7, 7, 1, 0, 3}}) {
      const Tensor expected = reference(weights, {ids.begin(), ids.end()});
      const network::Matrix& states = encoder.run(ids);
      for (std::size_t i = 0; i < ids.size(); ++i) {
        for (int j = 0; j < kHidden; ++j) {
          const auto row = static_cast<std::int64_t>(i);
          ASSERT_NEAR(states(row, j), expected[row][j].item<float>(), 1e-5) << i << " " << j;
        }
      }
    }
  }
}

TEST(BertEquality, ASentenceIsTheMeanOfItsPiecesWithLengthOne) {
  const auto folder = std::filesystem::temp_directory_path() / ("bert_test_" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  const auto weights = random_weights();
  const auto bytes = file_of(weights, "");
  std::ofstream(folder / "model.safetensors", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  std::ofstream(folder / "config.json")
      << R"({"num_attention_heads": 3, "layer_norm_eps": 1e-12, "hidden_act": "gelu"})";
  std::ofstream(folder / "vocab.txt") << kVocab;
  const auto encoder = BertEncoder::load(folder);
  ASSERT_TRUE(encoder) << encoder.error().message;
  std::vector<float> vector(kHidden);
  ASSERT_TRUE((*encoder)->encode("Fill the mugs with water", vector));
  Tensor expected = reference(weights, {2, 4, 9, 5, 8, 6, 7, 3}).mean(0);
  expected = expected / expected.norm();
  for (int j = 0; j < kHidden; ++j)
    EXPECT_NEAR(vector[static_cast<std::size_t>(j)], expected[j].item<float>(), 1e-5);
  EXPECT_FALSE(BertEncoder::load(folder / "absent"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace goalnet::inference
