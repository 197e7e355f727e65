// SentenceBERT: WordPiece, a BERT-shaped transformer, mean over the pieces, length 1. Inference in Eigen.
//
// For users who bring the weights; none ship with the project. Devlin et al. 2019, Reimers and Gurevych 2019.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "components/goalnet/encoder/bert_weights.h"
#include "components/goalnet/encoder/sentence_encoder.h"
#include "components/goalnet/encoder/wordpiece.h"

namespace goalnet::inference {

class BertEncoder : public SentenceEncoder {
 public:
  // A folder with model.safetensors, config.json and vocab.txt, as Hugging Face lays them out. Errors:
  // kInvalidRequest.
  static Expected<std::unique_ptr<BertEncoder>> load(const std::filesystem::path& folder);

  // `name` is stored in models trained with this encoder.
  BertEncoder(BertWeights weights, WordPiece pieces, std::string name);

  std::string_view name() const override { return name_; }
  int dimension() const override { return weights_.hidden(); }
  Expected<void> encode(std::string_view sentence, std::span<float> out) override;
  // The transformer alone: the last hidden state of each piece, pieces x hidden. Ids must be in the
  // vocabulary.
  const network::Matrix& run(std::span<const int> ids);

 private:
  void attend(const BertLayer& layer);

  BertWeights weights_;
  WordPiece pieces_;
  std::string name_;
  network::Matrix state_, query_, key_, value_, mixed_, inner_, scores_;
};

}  // namespace goalnet::inference
