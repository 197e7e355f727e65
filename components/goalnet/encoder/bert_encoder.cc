#include "components/goalnet/encoder/bert_encoder.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace goalnet::inference {
namespace {

constexpr std::size_t kMaxPieces = 128;  // as SentenceBERT's small models cut sentences

void apply(const DenseLayer& layer, const network::Matrix& in, network::Matrix& out) {
  out.noalias() = in * layer.weight.transpose();
  out.rowwise() += layer.bias.transpose();
}

void normalise(const NormLayer& layer, float epsilon, network::Matrix& rows) {
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    auto row = rows.row(i).array();
    row -= row.mean();
    row /= std::sqrt(row.square().mean() + epsilon);
    row = row * layer.scale.transpose().array() + layer.shift.transpose().array();
  }
}

}  // namespace

Expected<std::unique_ptr<BertEncoder>> BertEncoder::load(const std::filesystem::path& folder) {
  const auto file = SafeTensors::load((folder / "model.safetensors").string());
  if (!file) return tl::unexpected(file.error());
  std::ifstream stream(folder / "config.json");
  std::ostringstream config;
  config << stream.rdbuf();
  auto weights = load_bert_weights(*file, config.str());
  if (!weights) return tl::unexpected(weights.error());
  auto pieces = WordPiece::load(folder / "vocab.txt");
  if (!pieces) return tl::unexpected(pieces.error());
  if (pieces->size() > static_cast<std::size_t>(weights->words.rows())) {
    return fail(Outcome::kInvalidRequest,
                folder.string() + ": vocab.txt has more pieces than the model has embeddings");
  }
  std::uint64_t hash = 0xcbf29ce484222325ull;
  for (const auto& [name, entry] : file->tensors()) {
    for (const std::byte byte : file->bytes(entry))
      hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3ull;
  }
  char text[40];
  std::snprintf(text, sizeof text, "bert-%d-%016llx", weights->hidden(),
                static_cast<unsigned long long>(hash));
  return std::make_unique<BertEncoder>(std::move(*weights), std::move(*pieces), text);
}

BertEncoder::BertEncoder(BertWeights weights, WordPiece pieces, std::string name)
    : weights_(std::move(weights)), pieces_(std::move(pieces)), name_(std::move(name)) {}

const network::Matrix& BertEncoder::run(std::span<const int> ids) {
  const auto length = static_cast<Eigen::Index>(ids.size());
  state_.resize(length, weights_.hidden());
  for (Eigen::Index i = 0; i < length; ++i) {
    state_.row(i) = weights_.words.row(ids[static_cast<std::size_t>(i)]) + weights_.positions.row(i) +
                    weights_.segment.transpose();
  }
  normalise(weights_.norm, weights_.epsilon, state_);
  for (const BertLayer& layer : weights_.layers) {
    attend(layer);
    apply(layer.inner, state_, inner_);
    inner_ = inner_.unaryExpr([](float x) { return 0.5F * x * (1 + std::erf(x * 0.70710678F)); });
    apply(layer.outer, inner_, mixed_);
    state_ += mixed_;
    normalise(layer.norm, weights_.epsilon, state_);
  }
  return state_;
}

void BertEncoder::attend(const BertLayer& layer) {
  apply(layer.query, state_, query_);
  apply(layer.key, state_, key_);
  apply(layer.value, state_, value_);
  const Eigen::Index width = state_.cols() / weights_.heads;
  const float scale = 1 / std::sqrt(static_cast<float>(width));
  for (int head = 0; head < weights_.heads; ++head) {
    const Eigen::Index begin = head * width;
    scores_.noalias() = query_.middleCols(begin, width) * key_.middleCols(begin, width).transpose();
    scores_ *= scale;
    for (Eigen::Index i = 0; i < scores_.rows(); ++i) {
      auto row = scores_.row(i).array();
      row = (row - row.maxCoeff()).exp();
      row /= row.sum();
    }
    query_.middleCols(begin, width) =
        scores_ * value_.middleCols(begin, width);  // this head's queries are used up
  }
  apply(layer.attention_out, query_, mixed_);
  state_ += mixed_;
  normalise(layer.attention_norm, weights_.epsilon, state_);
}

Expected<void> BertEncoder::encode(std::string_view sentence, std::span<float> out) {
  if (out.size() != static_cast<std::size_t>(dimension()))
    return fail(Outcome::kInternal, "a sentence vector of the wrong size was asked for");
  const std::size_t most = std::min(kMaxPieces, static_cast<std::size_t>(weights_.positions.rows()));
  if (most < 3) return fail(Outcome::kInvalidRequest, "the sentence encoder has too few positions");
  const auto& states = run(pieces_.encode(sentence, most));
  Eigen::Map<network::Vector> vector(out.data(), static_cast<Eigen::Index>(out.size()));
  vector = states.colwise().mean().transpose();
  const float length = vector.norm();
  if (length > 0) vector /= length;
  return {};
}

}  // namespace goalnet::inference
