#include "components/goalnet/training/model_writer.h"

#include <nlohmann/json.hpp>

namespace goalnet::inference::training {

Expected<SafeTensorsWriter> make_model_file(const network::NetworkConfig& config,
                                            const Vocabulary& vocabulary,
                                            const std::map<std::string, torch::Tensor>& tensors,
                                            const network::Calibration& calibration) {
  SafeTensorsWriter writer;
  for (const auto& [name, tensor] : tensors) {
    const torch::Tensor flat = tensor.detach().contiguous();
    const auto added =
        writer.add(name, {static_cast<std::uint64_t>(flat.size(0)), static_cast<std::uint64_t>(flat.size(1))},
                   {flat.data_ptr<float>(), static_cast<std::size_t>(flat.numel())});
    if (!added) return tl::unexpected(added.error());
  }
  writer.metadata("goalnet.kind", "network");
  writer.metadata(network::kConfigKey, network::to_json(config));
  writer.metadata(network::kLexiconKey, vocabulary.lexicon.to_json());
  writer.metadata(network::kGrammarKey, vocabulary.grammar.to_json(vocabulary.lexicon.classes()));
  writer.metadata(network::kCalibrationKey, nlohmann::json({calibration.slope, calibration.offset}).dump());
  return writer;
}

}  // namespace goalnet::inference::training
