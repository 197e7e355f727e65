#include "components/goalnet/ranker/unseen_pools.h"

#include <span>

namespace goalnet::inference {
namespace {

// The run that a person did.
CandidateRun demonstrated_run(const Example& example) {
  CandidateRun truth;
  truth.end = example.states.back();
  truth.change = delta(example.states.front(), example.states.back());
  truth.actions = example.actions;
  return truth;
}

void score(UnseenPool& pool, const Example& example) {
  pool.start = example.states.front();
  pool.truth = demonstrated_run(example);
  for (const CandidateRun& run : pool.pool) pool.scores.push_back(agreement(run, pool.truth));
}

// Of each run what playing it again does not give: weight, macros, features. (The shares of the weight and
// the log probability are among the features.) Symbols are numbered alike for the same demonstrations.
std::vector<float> pack(const std::vector<UnseenPool>& pools) {
  std::vector<float> out;
  for (const UnseenPool& pool : pools) {
    out.push_back(static_cast<float>(pool.pool.size()));
    for (std::size_t i = 0; i < pool.pool.size(); ++i) {
      const CandidateRun& run = pool.pool[i];
      out.push_back(run.weight);
      out.push_back(static_cast<float>(run.macros.size()));
      for (const SymAction& macro : run.macros)
        out.insert(out.end(), {static_cast<float>(macro.verb), static_cast<float>(macro.x),
                               static_cast<float>(macro.y)});
      out.insert(out.end(), pool.features[i].begin(), pool.features[i].end());
    }
  }
  return out;
}

// Takes numbers from a list from left to right; zeros behind its end.
class Unpacker {
 public:
  explicit Unpacker(std::span<const float> values) : values_(values) {}
  float next() {
    if (at_ < values_.size()) return values_[at_++];
    good_ = false;
    return 0;
  }
  // A whole number from 0 to `most`; 0 for anything else.
  std::size_t count(std::size_t most) {
    const float value = next();
    if (value >= 0 && value <= static_cast<float>(most)) return static_cast<std::size_t>(value);
    good_ = false;
    return 0;
  }
  bool good() const { return good_; }
  bool good_at_end() const { return good_ && at_ == values_.size(); }

 private:
  std::span<const float> values_;
  std::size_t at_ = 0;
  bool good_ = true;
};

Expected<std::vector<UnseenPool>> unpack(const std::vector<float>& values,
                                         const std::vector<const Example*>& unseen, int fold,
                                         const std::string& stage) {
  constexpr std::size_t kMost = 100000;
  Unpacker in(values);
  std::vector<UnseenPool> pools;
  for (const Example* example : unseen) {
    UnseenPool pool;
    pool.fold = fold;
    const std::size_t runs = in.count(kMost);
    for (std::size_t i = 0; i < runs && in.good(); ++i) {
      const float weight = in.next();
      std::vector<SymAction> macros(in.count(kMost));
      for (SymAction& macro : macros) {
        macro.verb = static_cast<Verb>(in.count(kVerbs - 1));
        macro.x = static_cast<Symbol>(in.count(kMaxSymbols - 1));
        macro.y = static_cast<Symbol>(in.count(kMaxSymbols - 1));
      }
      pool.pool.push_back(play(example->states.front(), macros));
      pool.pool.back().weight = weight;
      for (float& feature : pool.features.emplace_back()) feature = in.next();
    }
    score(pool, *example);
    pools.push_back(std::move(pool));
  }
  if (!in.good_at_end())
    return fail(Outcome::kInvalidRequest,
                "the checkpoint's \"" + stage + "\" is damaged; remove the file (--fresh) to start anew");
  return pools;
}

}  // namespace

Expected<std::vector<UnseenPool>> unseen_pools(const std::vector<const Example*>& seen,
                                               const std::vector<const Example*>& unseen, int fold,
                                               const Lexicon& lexicon, bool grounding,
                                               const RankerOptions& options, Checkpoint& checkpoint,
                                               const std::string& stage,
                                               const std::function<bool(double)>& progress) {
  if (const auto* known = checkpoint.find(stage)) return unpack(*known, unseen, fold, stage);
  bool stopped = false;
  const auto tell = [&](double part) {
    stopped = stopped || !progress(part);
    return !stopped;
  };
  const Ranker ranker = train_ranker(seen, lexicon, grounding, options, [&](int epoch, double) {
    return tell(0.5 * (epoch + 1.0) / options.training.epochs);
  });
  const Error cancelled{Outcome::kCancelled, "training was stopped"};
  if (stopped) return tl::unexpected(cancelled);
  std::vector<UnseenPool> pools;
  for (const Example* example : unseen) {
    if (!tell(0.5 + 0.5 * static_cast<double>(pools.size()) / static_cast<double>(unseen.size())))
      return tl::unexpected(cancelled);
    const Instruction& instruction = grounding ? example->given : example->none;
    const SymState& start = example->states.front();
    const Reading& reading = grounding ? example->read_given : example->read_none;
    auto [pool, hints] = propose(ranker, lexicon, instruction, reading, start, hash_text(example->id));
    UnseenPool unseen_pool;
    unseen_pool.fold = fold;
    unseen_pool.features = run_features(pool, AgreementTable(pool), instruction, start, hints);
    unseen_pool.pool = std::move(pool);
    score(unseen_pool, *example);
    pools.push_back(std::move(unseen_pool));
  }
  if (auto kept = checkpoint.keep(stage, pack(pools)); !kept) return tl::unexpected(kept.error());
  return pools;
}

}  // namespace goalnet::inference
