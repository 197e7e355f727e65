#include "components/goalnet/training/trainer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <map>
#include <numbers>
#include <numeric>
#include <sstream>

#include "components/goalnet/network/network_model.h"
#include "components/goalnet/training/augmentation.h"
#include "components/goalnet/training/calibration.h"
#include "components/goalnet/training/checkpoint.h"
#include "components/goalnet/training/model_writer.h"
#include "components/goalnet/training/planner_feeding.h"
#include "components/goalnet/training/torch_network.h"

namespace goalnet::inference::training {
namespace {

// All that decides the weights, as text: a checkpoint made from anything else is not resumed.
std::string identity_of(const std::vector<Demonstration>& demonstrations, const TrainOptions& o) {
  std::string text = "1 " + std::to_string(fingerprint(demonstrations)) + network::to_json(o.config);
  for (const double value :
       {o.learning_rate, o.weight_decay, o.dropout, o.without_grounding, o.state_feeding, o.replacement,
        static_cast<double>(o.feeding_from), static_cast<double>(o.epochs), static_cast<double>(o.batch),
        static_cast<double>(o.seed), static_cast<double>(o.compress), static_cast<double>(o.perturbed),
        static_cast<double>(o.with_planner)}) {
    text += " " + std::to_string(value);
  }
  return text;
}

// std::shuffle differs between standard libraries; this does not.
void shuffle(std::vector<std::size_t>& order, std::mt19937_64& random) {
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
}

// The encoder of a training, remembered sentence by sentence: each is read a thousand times.
class RememberingEncoder : public SentenceEncoder {
 public:
  explicit RememberingEncoder(std::shared_ptr<SentenceEncoder> encoder) : encoder_(std::move(encoder)) {}
  std::string_view name() const override { return encoder_->name(); }
  int dimension() const override { return encoder_->dimension(); }
  Expected<void> encode(std::string_view sentence, std::span<float> out) override {
    auto [place, fresh] = known_.try_emplace(std::string(sentence));
    if (fresh) {
      place->second.resize(out.size());
      if (auto done = encoder_->encode(sentence, place->second); !done) {
        known_.erase(place);
        return done;
      }
    }
    std::copy(place->second.begin(), place->second.end(), out.begin());
    return {};
  }

 private:
  std::shared_ptr<SentenceEncoder> encoder_;
  std::map<std::string, std::vector<float>> known_;
};

// What GoalModels own, while all of one training share it.
class SharedEncoder : public SentenceEncoder {
 public:
  explicit SharedEncoder(std::shared_ptr<SentenceEncoder> encoder) : encoder_(std::move(encoder)) {}
  std::string_view name() const override { return encoder_->name(); }
  int dimension() const override { return encoder_->dimension(); }
  Expected<void> encode(std::string_view sentence, std::span<float> out) override {
    return encoder_->encode(sentence, out);
  }

 private:
  std::shared_ptr<SentenceEncoder> encoder_;
};

class Trainer {
 public:
  Trainer(const TrainOptions& options, const Vocabulary& vocabulary, std::vector<Episode> episodes,
          std::vector<Episode> held_out)
      : options_(options),
        vocabulary_(vocabulary),
        episodes_(std::move(episodes)),
        held_out_(std::move(held_out)),
        network_(options.config, vocabulary, options.seed),
        adam_(network_.parameters(), {.weight_decay = options.weight_decay}),
        augmentation_(vocabulary, episodes_),
        encoder_(options.encoder ? std::make_shared<RememberingEncoder>(options.encoder) : nullptr),
        simulator_(options.with_planner ? planner_simulator() : Simulator(sym_sim)) {}

  Expected<TrainedNetwork> run(const std::string& identity, const Progress& progress) {
    std::vector<EpochReport> curve;
    if (!options_.checkpoint.empty()) {
      auto resumed = read_checkpoint(options_.checkpoint, identity, network_.parameters(), adam_, curve);
      if (!resumed) return tl::unexpected(resumed.error());
    }
    double spent = 0;
    int timed = 0;
    for (int epoch = static_cast<int>(curve.size()); epoch < options_.epochs; ++epoch) {
      const auto begin = std::chrono::steady_clock::now();
      auto report = run_epoch(epoch);
      if (!report) return tl::unexpected(report.error());
      report->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      spent += report->seconds;
      report->seconds_left = spent / ++timed * (options_.epochs - epoch - 1);
      curve.push_back(*report);
      if (!options_.checkpoint.empty()) {
        auto written = write_checkpoint(options_.checkpoint, identity, network_.parameters(), adam_, curve);
        if (!written) return tl::unexpected(written.error());
      }
      if (progress) progress(*report);
    }
    auto file = model_file(calibration_);
    if (!file) return tl::unexpected(file.error());
    if (!held_out_.empty() && !encoder_) {
      auto fitted = calibrate(*file);
      if (!fitted) return tl::unexpected(fitted.error());
      file = model_file(*fitted);
    }
    return TrainedNetwork{std::move(*file), std::move(curve)};
  }

 private:
  Expected<SafeTensorsWriter> model_file(const network::Calibration& calibration) const {
    auto file = make_model_file(options_.config, vocabulary_, network_.tensors(), calibration);
    if (file && encoder_) file->metadata("goalnet.encoder", std::string(encoder_->name()));
    return file;
  }

  Expected<network::Calibration> calibrate(const SafeTensorsWriter& file) const {
    auto parsed = SafeTensors::parse(file.bytes(), "the trained model");
    if (!parsed) return tl::unexpected(parsed.error());
    auto samples = calibration_samples(*parsed, held_out_, false);
    if (!samples) return tl::unexpected(samples.error());
    return fit_calibration(*samples);
  }

  // The present weights in the Eigen network, to walk through episodes quickly.
  Expected<std::unique_ptr<GoalModel>> present_model() const {
    auto file = model_file(calibration_);
    if (!file) return tl::unexpected(file.error());
    auto parsed = SafeTensors::parse(file->bytes(), "the model in training");
    if (!parsed) return tl::unexpected(parsed.error());
    return make_network_model(*parsed, encoder_ ? std::make_unique<SharedEncoder>(encoder_) : nullptr);
  }

  Expected<EncodedEpisode> encode(EpisodeEncoder& encoder, const Episode& episode,
                                  bool with_grounding) const {
    auto encoded = encoder.encode(episode, with_grounding);
    if (!encoded || !encoder_) return encoded;
    encoded->external.resize(static_cast<std::size_t>(encoder_->dimension()));
    if (auto done = encoder_->encode(episode.sentence, encoded->external); !done)
      return tl::unexpected(done.error());
    return encoded;
  }

  Expected<EpochReport> run_epoch(int epoch) {
    // Every epoch's chances follow from the seed and its number alone, so that a resumed training goes on the
    // same.
    std::mt19937_64 random(options_.seed * 1000003 + static_cast<std::uint64_t>(epoch));
    torch::manual_seed(options_.seed * 1000003 + static_cast<std::uint64_t>(epoch));
    std::unique_ptr<GoalModel> model;
    if (options_.state_feeding > 0 && epoch >= options_.feeding_from) {
      auto made = present_model();
      if (!made) return tl::unexpected(made.error());
      model = std::move(*made);
    }
    EpisodeEncoder encoder(options_.config, vocabulary_);
    std::vector<EncodedEpisode> encoded;
    encoded.reserve(episodes_.size());
    std::bernoulli_distribution hide(options_.without_grounding), replace(options_.replacement);
    for (const Episode& original : episodes_) {
      const bool with_grounding = !hide(random);
      Episode episode = replace(random) ? augmentation_.replaced(original, random) : original;
      if (model)
        episode = feed_states(episode, with_grounding, *model, simulator_, options_.state_feeding, 4, random);
      auto example = encode(encoder, episode, with_grounding);
      if (!example) return tl::unexpected(example.error());
      encoded.push_back(std::move(*example));
    }
    std::vector<std::size_t> order(encoded.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    shuffle(order, random);
    EpochReport report{.epoch = epoch, .epochs = options_.epochs};
    int steps = 0, right = 0;
    const std::size_t batch = static_cast<std::size_t>(options_.batch),
                      batches = (order.size() + batch - 1) / batch;
    for (std::size_t b = 0; b < batches; ++b) {
      std::vector<const EncodedEpisode*> chosen;
      for (std::size_t i = b * batch; i < std::min(order.size(), (b + 1) * batch); ++i)
        chosen.push_back(&encoded[order[i]]);
      const LossReport loss = network_.loss(chosen, encoder.names(), options_.dropout);
      loss.loss.backward();
      const double done = (epoch + static_cast<double>(b) / static_cast<double>(batches)) / options_.epochs;
      const double warm = std::min(1.0, 20 * done);  // the first twentieth grows from nothing
      adam_.step(options_.learning_rate * warm * 0.5 * (1 + std::cos(std::numbers::pi * done)));
      report.loss += loss.loss.item<double>() * loss.steps;
      steps += loss.steps;
      right += loss.right;
    }
    report.loss /= std::max(1, steps);
    report.accuracy = static_cast<double>(right) / std::max(1, steps);
    if (auto measured = measure_held_out(report); !measured) return tl::unexpected(measured.error());
    return report;
  }

  Expected<void> measure_held_out(EpochReport& report) const {
    if (held_out_.empty()) return {};
    torch::NoGradGuard no_gradients;
    EpisodeEncoder encoder(options_.config, vocabulary_);
    int steps = 0, right = 0;
    for (const Episode& episode : held_out_) {
      auto example = encode(encoder, episode, true);
      if (!example) return tl::unexpected(example.error());
      const EncodedEpisode* one[] = {&*example};
      const LossReport loss = network_.loss(one, encoder.names(), 0);
      report.held_out_loss += loss.loss.item<double>() * loss.steps;
      steps += loss.steps;
      right += loss.right;
    }
    report.held_out_loss /= std::max(1, steps);
    report.held_out_accuracy = static_cast<double>(right) / std::max(1, steps);
    return {};
  }

  const TrainOptions& options_;
  // Of a training without held-out demonstrations: what the default options gave on fold 2 of 5 (goalnet ablate's folds).
  const network::Calibration calibration_{3.0264, 0.5255};
  const Vocabulary& vocabulary_;
  std::vector<Episode> episodes_, held_out_;
  TorchNetwork network_;
  Adam adam_;
  Augmentation augmentation_;
  std::shared_ptr<SentenceEncoder> encoder_;
  Simulator simulator_;
};

std::vector<Episode> make_episodes(const std::vector<Demonstration>& demonstrations, const Lexicon& things,
                                   const TrainOptions& options) {
  std::vector<Episode> episodes;
  for (const Demonstration& demonstration : demonstrations) {
    if (demonstration.perturbed && !options.perturbed) continue;
    episodes.push_back(make_episode(demonstration, things, options.compress));
  }
  return episodes;
}

}  // namespace

Expected<TrainedNetwork> train_network(const std::vector<Demonstration>& demonstrations,
                                       const std::vector<Demonstration>& held_out, const Lexicon& things,
                                       const WordVectors& vectors, const TrainOptions& options,
                                       const Progress& progress) {
  torch::set_num_threads(1);
  if (auto checked = network::parse_network_config(network::to_json(options.config)); !checked)
    return tl::unexpected(checked.error());
  const bool external = options.config.encoding == network::SentenceEncoding::kExternal;
  if (external != (options.encoder != nullptr) ||
      (external && options.encoder->dimension() != options.config.external)) {
    return fail(Outcome::kInvalidRequest,
                "the external sentence encoding and the encoder given do not fit together");
  }
  std::vector<Episode> episodes = make_episodes(demonstrations, things, options);
  if (episodes.empty()) return fail(Outcome::kInvalidRequest, "no demonstration to learn from");
  const auto vocabulary = make_vocabulary(episodes, vectors, options.config.word, options.constants);
  if (!vocabulary) return tl::unexpected(vocabulary.error());
  Trainer trainer(options, *vocabulary, std::move(episodes), make_episodes(held_out, things, options));
  auto trained = trainer.run(identity_of(demonstrations, options), progress);
  if (!trained) return trained;
  std::ostringstream data;
  data << std::hex << std::setw(16) << std::setfill('0') << fingerprint(demonstrations);
  trained->file.metadata(
      "goalnet.data", std::to_string(demonstrations.size()) + " demonstrations, fingerprint " + data.str());
  trained->file.metadata("goalnet.command", options.command);
  return trained;
}

}  // namespace goalnet::inference::training
