#include "components/goalnet/ranker/run_features.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace goalnet::inference {
namespace {

// Fills a row from left to right.
class Row {
 public:
  explicit Row(RunFeatures& row) : row_(row) { row_.fill(0); }
  template <class... Values>
  void put(Values... values) {
    ((row_[column_++] = static_cast<float>(values)), ...);
  }

 private:
  RunFeatures& row_;
  std::size_t column_ = 0;
};

Agreement expected(const std::vector<CandidateRun>& pool, const AgreementTable& table, std::size_t run,
                   float CandidateRun::*weight) {
  Agreement sum;
  float total = 1e-9f;
  for (std::size_t truth = 0; truth < pool.size(); ++truth) {
    const float w = pool[truth].*weight;
    if (w <= 0) continue;
    const Agreement& one = table(run, truth);
    total += w;
    sum.sji += w * one.sji, sum.f1 += w * one.f1, sum.ied += w * one.ied, sum.grr += w * one.grr;
  }
  sum.sji /= total, sum.f1 /= total, sum.ied /= total, sum.grr /= total;
  return sum;
}

// The objects that a run handles, as indices into the instruction's objects.
std::set<int> touched_by(const CandidateRun& run, const Instruction& instruction) {
  std::set<int> touched;
  for (const SymAction& action : run.macros)
    for (const Symbol symbol : {action.x, action.y})
      if (const int found = instruction.find(symbol); found >= 0) touched.insert(found);
  return touched;
}

// What the pool has in common, so that a run can be compared with it.
struct PoolView {
  std::vector<Agreement> all;                  // of each run with the rest
  std::vector<std::set<int>> touched;          // by each run
  std::vector<float> touched_share;            // of each object: weight of the runs that handle it
  float best = 0, best_log = -1e9f;            // of the runs: expected agreement, log probability
  float macros = 0, actions = 0, changes = 0;  // weighted means
};

PoolView view(const std::vector<CandidateRun>& pool, const AgreementTable& table,
              const Instruction& instruction) {
  PoolView view;
  view.touched_share.assign(instruction.objects.size(), 0.0f);
  for (std::size_t i = 0; i < pool.size(); ++i) {
    const CandidateRun& run = pool[i];
    view.all.push_back(expected(pool, table, i, &CandidateRun::weight));
    view.touched.push_back(touched_by(run, instruction));
    for (const int object : view.touched.back())
      view.touched_share[static_cast<std::size_t>(object)] += run.weight;
    view.best = std::max(view.best, view.all.back().mean());
    view.best_log = std::max(view.best_log, run.log_probability);
    view.macros += run.weight * static_cast<float>(run.macros.size());
    view.actions += run.weight * static_cast<float>(run.actions.size());
    view.changes += run.weight * static_cast<float>(run.change.added.size() + run.change.removed.size());
  }
  return view;
}

void put_agreement(Row& row, const std::vector<CandidateRun>& pool, const AgreementTable& table,
                   const PoolView& view, std::size_t i) {
  const CandidateRun& run = pool[i];
  for (const Agreement& a : {view.all[i], expected(pool, table, i, &CandidateRun::sampled),
                             expected(pool, table, i, &CandidateRun::replayed)})
    row.put(a.sji, a.f1, a.ied, a.grr, a.mean());
  const float mean = view.all[i].mean();
  row.put(mean - view.best, view.best, (mean - run.weight) / (1.0001f - run.weight));
  row.put(run.weight, run.sampled, run.replayed, run.read, i == 0);
  const auto steps = static_cast<float>(run.macros.size());
  row.put(run.log_probability, run.log_probability / (steps + 1), run.log_probability - view.best_log);
  float heavier = 0, better = 0, same_first = 0, same_last = 0;
  for (std::size_t j = 0; j < pool.size(); ++j) {
    heavier += pool[j].weight > run.weight;
    better += view.all[j].mean() > mean;
    if (run.macros.empty() || pool[j].macros.empty()) continue;
    if (pool[j].macros.front() == run.macros.front()) same_first += pool[j].weight;
    if (pool[j].macros.back() == run.macros.back()) same_last += pool[j].weight;
  }
  row.put(heavier, better, same_first, same_last);
  const auto changes = static_cast<float>(run.change.added.size() + run.change.removed.size());
  const auto actions = static_cast<float>(run.actions.size());
  row.put(steps, actions, changes, steps - view.macros, actions - view.actions, changes - view.changes);
}

void put_objects(Row& row, const CandidateRun& run, const PoolView& view, std::size_t i,
                 const Instruction& instruction, const SymState& start) {
  std::set<int> named_mentions, handled;
  for (const SeenObject& object : instruction.objects)
    if (object.mention >= 0 && object.level >= NameLevel::kName) named_mentions.insert(object.mention);
  float named = 0, unnamed = 0, left_out = 0, near = 0, rivals = 0, rank = 0, least_share = 1, share = 0;
  for (const int index : view.touched[i]) {
    const SeenObject& object = instruction.objects[static_cast<std::size_t>(index)];
    if (object.mention >= 0) handled.insert(object.mention);
    (object.mention >= 0 ? named : unnamed) += 1;
    near += start.near(object.symbol);
    rivals += static_cast<float>(std::min(object.rivals, 6));
    rank += object.rank;
    share += view.touched_share[static_cast<std::size_t>(index)];
    least_share = std::min(least_share, view.touched_share[static_cast<std::size_t>(index)]);
  }
  for (const int mention : named_mentions) left_out += !handled.contains(mention);
  float missed = 0;  // what most other runs handle
  for (std::size_t k = 0; k < view.touched_share.size(); ++k)
    if (!view.touched[i].contains(static_cast<int>(k)))
      missed += std::max(0.0f, view.touched_share[k] - 0.3f);
  const float all = std::max(1.0f, static_cast<float>(view.touched[i].size()));
  row.put(unnamed, named, left_out, named_mentions.size(), near / all, rivals / all, rank / all, share / all,
          least_share, missed);
  float held_at_start = 0, held_at_end = 0, held_used = 0;
  for (const SymFact fact : start.facts()) {
    if (relation_of(fact) != Relation::kGrasping) continue;
    ++held_at_start;
    held_used += view.touched[i].contains(instruction.find(object_of(fact)));
  }
  for (const SymFact fact : run.end.facts()) held_at_end += relation_of(fact) == Relation::kGrasping;
  row.put(held_at_start, held_at_end, held_used, instruction.words.size(), instruction.first_frame);
}

void put_votes(Row& row, const CandidateRun& run, const Instruction& instruction, const Hints& hints) {
  const auto& votes = hints.votes;
  const auto class_of = [&](Symbol symbol) {
    const int found = instruction.find(symbol);
    return found < 0 ? kNoClass : instruction.objects[static_cast<std::size_t>(found)].class_id;
  };
  float sum = 0, least = 1, wanted = 0, got = 0, length = 0;
  for (const SymAction& action : run.macros) {
    float vote = 0;
    for (const NeighbourVote& v : votes)
      if (v.verb == action.verb && v.x == class_of(action.x) && v.y == class_of(action.y)) vote = v.weight;
    sum += vote;
    least = std::min(least, vote);
  }
  for (const NeighbourVote& v : votes) {
    if (v.verb == Verb::kStop) {
      if (v.y == std::min<std::size_t>(run.macros.size(), 6)) length = v.weight;
      continue;
    }
    wanted += v.weight;
    for (const SymAction& action : run.macros)
      if (v.verb == action.verb && v.x == class_of(action.x) && v.y == class_of(action.y)) {
        got += v.weight;
        break;
      }
  }
  float habit_sum = 0, habit_least = 1, habit_got = 0, habit_all = 0;
  for (const Habit& habit : hints.habits) habit_all += habit.weight;
  std::set<SymAction> once;
  for (const SymAction& action : run.macros) {
    float weight = 0;
    for (const Habit& habit : hints.habits)
      if (habit.action == action) weight = habit.weight;
    habit_sum += weight;
    habit_least = std::min(habit_least, weight);
    if (once.insert(action).second) habit_got += weight;
  }
  const auto steps = static_cast<float>(run.macros.size());
  row.put(habit_sum / std::max(1.0f, steps), habit_least, habit_got, habit_all - habit_got,
          2 * habit_got / (habit_all + steps + 1e-6f));
  row.put(sum / std::max(1.0f, steps), least, got, wanted - got, 2 * got / (wanted + steps + 1e-6f), length);
}

}  // namespace

AgreementTable::AgreementTable(const std::vector<CandidateRun>& pool)
    : size_(pool.size()), cells_(size_ * size_) {
  for (std::size_t i = 0; i < size_; ++i)
    for (std::size_t j = i; j < size_; ++j)
      std::tie(cells_[i * size_ + j], cells_[j * size_ + i]) = mutual_agreement(pool[i], pool[j]);
}

std::vector<RunFeatures> run_features(const std::vector<CandidateRun>& pool, const AgreementTable& table,
                                      const Instruction& instruction, const SymState& start,
                                      const Hints& hints) {
  std::vector<RunFeatures> rows(pool.size());
  const PoolView pool_view = view(pool, table, instruction);
  const CandidateRun reading = play(start, hints.reading.macros);
  for (std::size_t i = 0; i < pool.size(); ++i) {
    const CandidateRun& run = pool[i];
    Row row(rows[i]);
    put_agreement(row, pool, table, pool_view, i);
    put_objects(row, run, pool_view, i, instruction, start);
    put_votes(row, run, instruction, hints);
    const Agreement read = agreement(run, reading);
    row.put(read.sji, read.ied, read.grr, agreement(reading, run).grr, hints.reading.complete,
            !reading.actions.empty());
    std::array<float, kVerbs> verbs{};
    for (const SymAction& action : run.macros) ++verbs[static_cast<std::size_t>(action.verb)];
    for (const Verb verb : {Verb::kMoveTo, Verb::kGrasp, Verb::kRelease, Verb::kKeepOn, Verb::kKeepIn,
                            Verb::kTurn, Verb::kOpen, Verb::kClose, Verb::kPress, Verb::kPour})
      row.put(verbs[static_cast<std::size_t>(verb)]);
    row.put(run.macros.empty() ? 0 : static_cast<int>(run.macros.back().verb),
            run.macros.empty() ? 0 : static_cast<int>(run.macros.front().verb));
  }
  return rows;
}

}  // namespace goalnet::inference
