#include "components/goalnet/encoder/bert_weights.h"

#include <optional>

#include <nlohmann/json.hpp>

namespace goalnet::inference {
namespace {

using Shape = std::vector<std::uint64_t>;

// Reads tensors one after the other and keeps the first error, so that the list of tensors reads like a list.
class Reader {
 public:
  explicit Reader(const SafeTensors& file)
      : file_(file), prefix_(file.contains("bert.embeddings.word_embeddings.weight") ? "bert." : "") {}

  network::Matrix matrix(const std::string& name, std::uint64_t rows, std::uint64_t cols) {
    const auto tensor = read(name, {rows, cols});
    if (tensor.values.empty()) return {};
    return Eigen::Map<const network::Matrix>(tensor.values.data(), static_cast<Eigen::Index>(tensor.shape[0]),
                                             static_cast<Eigen::Index>(tensor.shape[1]));
  }
  network::Vector vector(const std::string& name, std::uint64_t size) {
    const auto tensor = read(name, {size});
    return Eigen::Map<const network::Vector>(tensor.values.data(),
                                             static_cast<Eigen::Index>(tensor.values.size()));
  }
  DenseLayer dense(const std::string& name, std::uint64_t out, std::uint64_t in) {
    DenseLayer layer{matrix(name + ".weight", out, in), {}};
    layer.bias = vector(name + ".bias", static_cast<std::uint64_t>(layer.weight.rows()));
    return layer;
  }
  NormLayer norm(const std::string& name, std::uint64_t size) {
    return {vector(name + ".weight", size), vector(name + ".bias", size)};
  }
  bool has(const std::string& name) const { return file_.contains(prefix_ + name); }
  const std::optional<Error>& error() const { return error_; }

 private:
  FloatTensor read(const std::string& name, const Shape& shape) {
    if (error_) return {};
    auto tensor = file_.floats(prefix_ + name, shape);
    if (tensor && !tensor->values.empty()) return std::move(*tensor);
    error_ = tensor ? Error{Outcome::kInvalidRequest, file_.name() + ": tensor \"" + name + "\" is empty"}
                    : tensor.error();
    return {};
  }

  const SafeTensors& file_;
  std::string prefix_;
  std::optional<Error> error_;
};

}  // namespace

Expected<BertWeights> load_bert_weights(const SafeTensors& file, const std::string& config_text) {
  BertWeights weights;
  const auto config = nlohmann::json::parse(config_text, nullptr, false);
  if (!config.is_object() || !config.contains("num_attention_heads") ||
      !config["num_attention_heads"].is_number_integer()) {
    return fail(Outcome::kInvalidRequest, file.name() + ": its config.json names no num_attention_heads");
  }
  const long long heads = config["num_attention_heads"].get<long long>();
  if (config.contains("layer_norm_eps") && config["layer_norm_eps"].is_number())
    weights.epsilon = config["layer_norm_eps"].get<float>();
  if (config.contains("hidden_act") && config["hidden_act"] != "gelu") {
    return fail(Outcome::kInvalidRequest,
                file.name() + ": its activation is not gelu, the only one that is supported");
  }
  Reader reader(file);
  weights.words = reader.matrix("embeddings.word_embeddings.weight", 0, 0);
  const auto hidden = static_cast<std::uint64_t>(weights.words.cols());
  if (!reader.error() && (heads < 1 || heads > static_cast<long long>(hidden) ||
                          hidden % static_cast<std::uint64_t>(heads) != 0)) {
    return fail(Outcome::kInvalidRequest, file.name() + ": " + std::to_string(heads) +
                                              " heads do not divide " + std::to_string(hidden));
  }
  weights.heads = static_cast<int>(heads);
  weights.positions = reader.matrix("embeddings.position_embeddings.weight", 0, hidden);
  const network::Matrix segments = reader.matrix("embeddings.token_type_embeddings.weight", 0, hidden);
  if (segments.rows() > 0) weights.segment = segments.row(0).transpose();
  weights.norm = reader.norm("embeddings.LayerNorm", hidden);
  for (int i = 0; i < 1000; ++i) {
    const std::string name = "encoder.layer." + std::to_string(i) + ".";
    if (!reader.has(name + "attention.self.query.weight") || reader.error()) break;
    BertLayer layer;
    layer.query = reader.dense(name + "attention.self.query", hidden, hidden);
    layer.key = reader.dense(name + "attention.self.key", hidden, hidden);
    layer.value = reader.dense(name + "attention.self.value", hidden, hidden);
    layer.attention_out = reader.dense(name + "attention.output.dense", hidden, hidden);
    layer.attention_norm = reader.norm(name + "attention.output.LayerNorm", hidden);
    layer.inner = reader.dense(name + "intermediate.dense", 0, hidden);
    layer.outer =
        reader.dense(name + "output.dense", hidden, static_cast<std::uint64_t>(layer.inner.weight.rows()));
    layer.norm = reader.norm(name + "output.LayerNorm", hidden);
    weights.layers.push_back(std::move(layer));
  }
  if (reader.error()) return tl::unexpected(*reader.error());
  if (weights.layers.empty())
    return fail(Outcome::kInvalidRequest, file.name() + " has no encoder.layer.0: it is no BERT model");
  return weights;
}

}  // namespace goalnet::inference
