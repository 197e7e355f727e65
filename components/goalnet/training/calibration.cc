#include "components/goalnet/training/calibration.h"

#include <algorithm>
#include <cmath>

#include "components/goalnet/network/network_core.h"
#include "components/goalnet/tokenizer.h"

namespace goalnet::inference::training {
namespace {

bool same(std::vector<Predicate> a, std::vector<Predicate> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

Goal goal_of(const network::DecodedGoal& decoded, const WorldState& state, const network::Grammar& grammar) {
  Goal goal;
  for (const network::DecodedPredicate& p : decoded.predicates) {
    std::string second;
    if (p.second >= 0) second = state.objects[static_cast<std::size_t>(p.second)];
    if (p.value >= 0) second = grammar.values()[static_cast<std::size_t>(p.value)];
    const Predicate fact = network::make_predicate(network::relation_of_token(p.token),
                                                   state.objects[static_cast<std::size_t>(p.main)], second);
    (network::is_positive_token(p.token) ? goal.positive : goal.negative).push_back(fact);
  }
  return goal;
}

}  // namespace

network::Calibration fit_calibration(const std::vector<CalibrationSample>& samples) {
  const network::Calibration prior{1, 3};
  constexpr double kPrior = 0.1;  // as strong as a tenth of a sample, so that few samples cannot run away
  network::Calibration fit = prior;
  for (int round = 0; round < 50; ++round) {
    double gs = kPrior * (prior.slope - fit.slope), go = kPrior * (prior.offset - fit.offset);
    double hss = kPrior, hso = 0, hoo = kPrior;
    for (const CalibrationSample& s : samples) {
      const double p = fit(s.mean_log_probability), x = s.mean_log_probability, error = (s.right ? 1 : 0) - p;
      gs += error * x;
      go += error;
      hss += p * (1 - p) * x * x;
      hso += p * (1 - p) * x;
      hoo += p * (1 - p);
    }
    const double determinant = hss * hoo - hso * hso;
    if (determinant < 1e-12) break;
    fit.slope += std::clamp((gs * hoo - go * hso) / determinant, -2.0, 2.0);
    fit.offset += std::clamp((go * hss - gs * hso) / determinant, -2.0, 2.0);
  }
  return fit;
}

Expected<std::vector<CalibrationSample>> calibration_samples(const SafeTensors& file,
                                                             const std::vector<Episode>& episodes,
                                                             bool with_grounding) {
  auto parts = network::load_parts(file);
  if (!parts) return tl::unexpected(parts.error());
  network::NetworkCore core(std::move(*parts));
  std::vector<CalibrationSample> samples;
  for (const Episode& episode : episodes) {
    auto words = tokenize(episode.sentence);
    if (!words) return tl::unexpected(words.error());
    core.set_words(std::move(*words));
    core.encode_sentence();
    for (std::size_t t = 0; t < episode.states.size(); ++t) {
      const auto decoded =
          core.step({episode.sentence, with_grounding ? &episode.grounding : nullptr,
                     std::span(episode.states).first(t + 1), std::span(episode.pursued).first(t)});
      if (!decoded) return tl::unexpected(decoded.error());
      const Goal goal = goal_of(**decoded, episode.states[t], core.parts().grammar);
      const Goal& wanted = episode.goals[t];
      samples.push_back({(*decoded)->log_probability / std::max(1, (*decoded)->choices),
                         same(goal.positive, wanted.positive) && same(goal.negative, wanted.negative)});
    }
  }
  return samples;
}

}  // namespace goalnet::inference::training
