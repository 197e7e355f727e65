#include "components/goalnet/network/model_parts.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace goalnet::inference::network {

double Calibration::operator()(double mean_log_probability) const {
  return 1 / (1 + std::exp(-(slope * mean_log_probability + offset)));
}

Expected<std::unique_ptr<ModelParts>> load_parts(const SafeTensors& file) {
  const auto refuse = [&file](const Error& error) {
    const bool named = error.message.starts_with(file.name());
    return tl::unexpected<Error>(
        Error{error.outcome, named ? error.message : file.name() + ": " + error.message});
  };
  const auto config_text = file.metadata(kConfigKey), lexicon_text = file.metadata(kLexiconKey),
             grammar_text = file.metadata(kGrammarKey), calibration_text = file.metadata(kCalibrationKey);
  for (const auto* text : {&config_text, &lexicon_text, &grammar_text, &calibration_text}) {
    if (!*text) return refuse(text->error());
  }
  auto config = parse_network_config(*config_text);
  if (!config) return refuse(config.error());
  auto lexicon = Lexicon::parse(*lexicon_text);
  if (!lexicon) return refuse(lexicon.error());
  auto grammar = Grammar::parse(*grammar_text, lexicon->classes());
  if (!grammar) return refuse(grammar.error());
  const auto calibration = nlohmann::json::parse(*calibration_text, nullptr, false);
  if (!calibration.is_array() || calibration.size() != 2 || !calibration[0].is_number() ||
      !calibration[1].is_number()) {
    return refuse({Outcome::kInvalidRequest, "the model's calibration is no pair of numbers"});
  }
  auto weights = load_weights(file, *config, sizes_of(*lexicon, *grammar));
  if (!weights) return refuse(weights.error());
  return std::unique_ptr<ModelParts>(
      new ModelParts{*config,
                     std::move(*lexicon),
                     std::move(*grammar),
                     std::move(*weights),
                     {calibration[0].get<double>(), calibration[1].get<double>()}});
}

}  // namespace goalnet::inference::network
