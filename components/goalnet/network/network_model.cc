#include "components/goalnet/network/network_model.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "components/goalnet/encoder/bert_encoder.h"
#include "components/goalnet/network/network_core.h"
#include "components/goalnet/tokenizer.h"

namespace goalnet::inference {
namespace {

using namespace network;

constexpr const char* kEncoderKey = "goalnet.encoder";
const std::string kEncoderVariable = "GOALNET_SENTENCE_ENCODER";

class NetworkModel : public GoalModel {
 public:
  NetworkModel(std::unique_ptr<ModelParts> parts, std::unique_ptr<SentenceEncoder> encoder)
      : core_(std::move(parts)), encoder_(std::move(encoder)) {
    if (encoder_ != nullptr) external_.resize(encoder_->dimension());
  }

  std::string_view kind() const override { return "network"; }

 private:
  Expected<Goal> do_infer(const StepInput& input) override {
    if (auto read = read_sentence(input.sentence); !read) return tl::unexpected(read.error());
    const auto decoded = core_.step(input);
    if (!decoded) return tl::unexpected(decoded.error());
    return to_goal(**decoded, input.states.back());
  }

  // The sentence stays the same over the steps of an instruction: its words and its encoding are kept.
  Expected<void> read_sentence(std::string_view text) {
    if (sentence_read_ && text == text_) return {};
    sentence_read_ = false;
    auto words = tokenize(text);
    if (!words) return tl::unexpected(words.error());
    if (words->empty()) return fail(Outcome::kNotUnderstood, "the instruction is empty");
    const std::string first = words->front();
    if (core_.set_words(std::move(*words)) == 0 && encoder_ == nullptr) {
      return fail(Outcome::kNotUnderstood, "no word of the instruction is known (the nearest to \"" +
                                               first.substr(0, 40) + "\" is \"" + nearest(first) + "\")");
    }
    if (encoder_ != nullptr) {
      if (auto done = encoder_->encode(text, {external_.data(), static_cast<std::size_t>(external_.size())});
          !done) {
        return tl::unexpected(done.error());
      }
      core_.encode_sentence(external_);
    } else {
      core_.encode_sentence();
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
    for (const std::string& b : core_.parts().lexicon.words()) {
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

  Goal to_goal(const DecodedGoal& decoded, const WorldState& state) const {
    Goal goal;
    const auto name = [&state](int object) { return state.objects[static_cast<std::size_t>(object)]; };
    for (const DecodedPredicate& p : decoded.predicates) {
      const GoalRelation relation = relation_of_token(p.token);
      std::string second;
      if (p.second >= 0) second = name(p.second);
      if (p.value >= 0) second = core_.parts().grammar.values()[static_cast<std::size_t>(p.value)];
      (is_positive_token(p.token) ? goal.positive : goal.negative)
          .push_back(make_predicate(relation, name(p.main), second));
    }
    goal.confidence = core_.parts().calibration(decoded.log_probability / std::max(1, decoded.choices));
    return goal;
  }

  NetworkCore core_;
  std::unique_ptr<SentenceEncoder> encoder_;
  Vector external_;
  std::string text_;
  bool sentence_read_ = false;
};

}  // namespace

Expected<std::unique_ptr<GoalModel>> make_network_model(const SafeTensors& file,
                                                        std::unique_ptr<SentenceEncoder> encoder) {
  auto parts = load_parts(file);
  if (!parts) return tl::unexpected(parts.error());
  const bool external = (*parts)->config.encoding == SentenceEncoding::kExternal;
  if (const char* folder = std::getenv(kEncoderVariable.c_str());
      external && encoder == nullptr && folder != nullptr) {
    auto loaded = BertEncoder::load(folder);
    if (!loaded) return tl::unexpected(loaded.error());
    encoder = std::move(*loaded);
  }
  if (external != (encoder != nullptr)) {
    return fail(Outcome::kInvalidRequest,
                file.name() + (external ? " needs the sentence encoder it was trained with: set " +
                                              kEncoderVariable + " to its folder"
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
