#include "components/goalnet/network/network_model.h"

#include <algorithm>
#include <string>
#include <vector>

#include "components/goalnet/network/decoder.h"
#include "components/goalnet/network/model_parts.h"
#include "components/goalnet/network/network.h"
#include "components/goalnet/network/world_encoder.h"
#include "components/goalnet/tokenizer.h"

namespace goalnet::inference {
namespace {

using namespace network;

constexpr std::size_t kMaxNames = 20000;  // a stream of ever new names must not fill the memory
constexpr const char* kEncoderKey = "goalnet.encoder";

class NetworkModel : public GoalModel {
 public:
  NetworkModel(std::unique_ptr<ModelParts> parts, std::unique_ptr<SentenceEncoder> encoder)
      : parts_(std::move(parts)),
        names_(parts_->lexicon, parts_->weights.vectors),
        world_encoder_(parts_->config, parts_->lexicon, parts_->grammar, parts_->weights.vectors, names_),
        network_(parts_->config, parts_->weights, names_),
        decoder_(parts_->config, parts_->grammar),
        encoder_(std::move(encoder)) {
    if (encoder_ != nullptr) external_.resize(encoder_->dimension());
  }

  std::string_view kind() const override { return "network"; }

 private:
  Expected<Goal> do_infer(const StepInput& input) override {
    if (names_.size() > kMaxNames) {
      names_.clear();
      network_.forget();
    }
    if (auto read = read_sentence(input.sentence); !read) return tl::unexpected(read.error());
    if (parts_->config.temporal == TemporalContext::kState) {
      // The memory reads every state so far, the present one last.
      network_.forget();
      for (std::size_t i = 0; i < input.states.size(); ++i) {
        if (auto read = read_world(input, i); !read) return tl::unexpected(read.error());
        network_.remember_state();
      }
    } else if (auto read = read_world(input, input.states.size() - 1); !read) {
      return tl::unexpected(read.error());
    }
    network_.start();
    decoder_.decode(network_, world_, decoded_);
    return to_goal(input.states.back());
  }

  Expected<void> read_world(const StepInput& input, std::size_t step) {
    const auto goals = input.goals.first(std::min(step, input.goals.size()));
    auto encoded =
        world_encoder_.encode(sentence_, texts_, input.grounding, input.states[step], goals, world_);
    if (encoded) network_.read_world(world_);
    return encoded;
  }

  // The sentence stays the same over the steps of an instruction: its words and its encoding are kept.
  Expected<void> read_sentence(std::string_view text) {
    if (sentence_read_ && text == text_) return {};
    sentence_read_ = false;
    auto words = tokenize(text);
    if (!words) return tl::unexpected(words.error());
    texts_ = std::move(*words);
    sentence_.words.clear();
    for (const std::string& word : texts_) sentence_.words.push_back(parts_->lexicon.word(word));
    if (texts_.empty()) return fail(Outcome::kNotUnderstood, "the instruction is empty");
    if (sentence_.known() == 0 && encoder_ == nullptr) {
      return fail(Outcome::kNotUnderstood, "no word of the instruction is known (the nearest to \"" +
                                               texts_[0].substr(0, 40) + "\" is \"" + nearest(texts_[0]) +
                                               "\")");
    }
    if (encoder_ != nullptr) {
      if (auto done = encoder_->encode(text, {external_.data(), static_cast<std::size_t>(external_.size())});
          !done) {
        return tl::unexpected(done.error());
      }
      network_.read_sentence(external_);
    } else {
      network_.read_sentence(sentence_.words);
    }
    text_ = text;
    sentence_read_ = true;
    return {};
  }

  // The known word with the smallest edit distance; the first of several.
  std::string nearest(const std::string& word) const {
    const std::string_view a = std::string_view(word).substr(0, 40);
    std::string best;
    std::size_t best_distance = 1000;
    std::vector<std::size_t> row;
    for (const std::string& b : parts_->lexicon.words()) {
      row.resize(b.size() + 1);
      for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
      for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j < row.size(); ++j) {
          const std::size_t up = row[j];
          row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1])});
          diagonal = up;
        }
      }
      if (row.back() < best_distance) {
        best_distance = row.back();
        best = b;
      }
    }
    return best;
  }

  Goal to_goal(const WorldState& state) const {
    Goal goal;
    const auto name = [&state](int object) { return state.objects[static_cast<std::size_t>(object)]; };
    for (const DecodedPredicate& p : decoded_.predicates) {
      const GoalRelation relation = relation_of_token(p.token);
      std::string second;
      if (p.second >= 0) second = name(p.second);
      if (p.value >= 0) second = parts_->grammar.values()[static_cast<std::size_t>(p.value)];
      (is_positive_token(p.token) ? goal.positive : goal.negative)
          .push_back(make_predicate(relation, name(p.main), second));
    }
    goal.confidence = parts_->calibration(decoded_.log_probability / std::max(1, decoded_.choices));
    return goal;
  }

  std::unique_ptr<ModelParts> parts_;
  NameTable names_;
  WorldEncoder world_encoder_;
  Network network_;
  Decoder decoder_;
  std::unique_ptr<SentenceEncoder> encoder_;
  Vector external_;
  std::string text_;
  bool sentence_read_ = false;
  std::vector<std::string> texts_;
  EncodedSentence sentence_;
  EncodedWorld world_;
  DecodedGoal decoded_;
};

}  // namespace

Expected<std::unique_ptr<GoalModel>> make_network_model(const SafeTensors& file,
                                                        std::unique_ptr<SentenceEncoder> encoder) {
  auto parts = load_parts(file);
  if (!parts) return tl::unexpected(parts.error());
  const bool external = (*parts)->config.encoding == SentenceEncoding::kExternal;
  if (external != (encoder != nullptr)) {
    return fail(Outcome::kInvalidRequest,
                file.name() + (external ? " needs the sentence encoder it was trained with"
                                        : " has its own sentence encoder; give it no other"));
  }
  if (external) {
    const auto name = file.metadata(kEncoderKey);
    if (!name) return tl::unexpected(name.error());
    if (*name != encoder->name() || (*parts)->config.external != encoder->dimension()) {
      return fail(Outcome::kInvalidRequest, file.name() + " was trained with the sentence encoder \"" +
                                                *name + "\", not with \"" + std::string(encoder->name()) +
                                                "\"");
    }
  }
  return std::make_unique<NetworkModel>(std::move(*parts), std::move(encoder));
}

}  // namespace goalnet::inference
