#include "tools/goalnet/train_network_kind.h"

#include <cstdio>

#include "components/core/config_path.h"
#include "components/goalnet/encoder/bert_encoder.h"
#include "components/goalnet/lexicon.h"
#include "components/goalnet/training/settings.h"
#include "components/goalnet/training/trainer.h"

namespace goalnet::tools {

using namespace inference::training;

Expected<void> train_network_kind(const TrainRequest& request) {
  const auto demonstrations = inference::read_demonstrations(request.data);
  if (!demonstrations) return tl::unexpected(demonstrations.error());
  inference::Symbols symbols;
  const auto things = inference::Lexicon::load(config_path("language/household.json"), symbols);
  if (!things) return tl::unexpected(things.error());
  const auto folder = request.data.parent_path();
  const auto vectors = read_word_vectors({folder / "conceptnet.json", folder / "vocab.json"});
  if (!vectors) return tl::unexpected(vectors.error());
  if (vectors->empty()) {
    std::fprintf(stderr,
                 "goalnet train: no word vectors (conceptnet.json) beside %s: words are learned from the "
                 "sentences alone\n",
                 request.data.c_str());
  }
  TrainOptions options;
  options.seed = request.seed;
  options.command = request.command;
  options.constants = (folder / "constants.json").string();
  options.checkpoint = request.out.string() + ".checkpoint";
  auto settings = request.settings;
  if (const auto encoder = settings.extract("encoder"); !encoder.empty()) {
    auto loaded = inference::BertEncoder::load(encoder.mapped());
    if (!loaded) return tl::unexpected(loaded.error());
    options.encoder = std::move(*loaded);
    options.config.encoding = inference::network::SentenceEncoding::kExternal;
    options.config.external = options.encoder->dimension();
  }
  if (auto applied = apply_settings(settings, options); !applied) return applied;
  if (request.fresh) std::filesystem::remove(options.checkpoint);
  const auto report = [&](const EpochReport& epoch) {
    char text[120];
    std::snprintf(text, sizeof text, "epoch %d of %d: loss %.3f, whole goals right %.1f %%", epoch.epoch + 1,
                  epoch.epochs, epoch.loss, 100 * epoch.accuracy);
    if (request.progress) request.progress(static_cast<double>(epoch.epoch + 1) / epoch.epochs, text);
  };
  const auto trained = train_network(*demonstrations, {}, *things, *vectors, options, report);
  if (!trained) return tl::unexpected(trained.error());
  if (auto written = trained->file.write(request.out.string()); !written) return written;
  std::error_code ignored;
  std::filesystem::remove(options.checkpoint, ignored);
  return {};
}

}  // namespace goalnet::tools
