#include "components/goalnet/network/decoder.h"

#include <algorithm>
#include <cmath>

#include "components/goalnet/network/index.h"

namespace goalnet::inference::network {
namespace {

bool related(const EncodedWorld& world, GoalRelation relation, int main, int second) {
  const int type = relation == GoalRelation::kIn ? 2 : 0;
  return std::any_of(world.edges.begin(), world.edges.end(), [&](const RelationEdge& edge) {
    return edge.type == type && edge.to == main && (second < 0 || edge.from == second);
  });
}

bool decoded(const DecodedGoal& goal, const DecodedPredicate& predicate) {
  return std::find(goal.predicates.begin(), goal.predicates.end(), predicate) != goal.predicates.end();
}

}  // namespace

bool Decoder::main_admitted(int token, int object, const EncodedWorld& world,
                            const DecodedGoal& so_far) const {
  const GoalRelation relation = relation_of_token(token);
  const bool positive = is_positive_token(token);
  if (decoded(so_far, {token, object, -1, -1})) return false;
  if (!config_.grammar_mask) return true;
  if (!grammar_.main_allowed(relation, world.class_id[at(object)], world.graspable[at(object)] != 0))
    return false;
  switch (relation) {
    case GoalRelation::kNear:
      return (world.near[at(object)] != 0) != positive;
    case GoalRelation::kGrasping:
      return (world.held[at(object)] != 0) != positive;
    case GoalRelation::kOn:
    case GoalRelation::kIn:
      return positive || related(world, relation, object, -1);
    case GoalRelation::kState: {
      for (int v = 0; v < static_cast<int>(grammar_.values().size()); ++v) {
        if (value_admitted(token, object, v, world, so_far)) return true;
      }
      return false;
    }
  }
  return false;
}

bool Decoder::second_admitted(int token, int main, int object, const EncodedWorld& world,
                              const DecodedGoal& so_far) const {
  const GoalRelation relation = relation_of_token(token);
  if (decoded(so_far, {token, main, object, -1})) return false;
  if (!config_.grammar_mask) return true;
  if (object == main || !grammar_.second_allowed(relation, world.class_id[at(object)])) return false;
  return related(world, relation, main, object) != is_positive_token(token);
}

bool Decoder::value_admitted(int token, int main, int value, const EncodedWorld& world,
                             const DecodedGoal& so_far) const {
  if (decoded(so_far, {token, main, -1, value})) return false;
  if (!config_.grammar_mask) return true;
  if (!grammar_.value_allowed(world.class_id[at(main)], value)) return false;
  return (world.value[at(main) * grammar_.values().size() + at(value)] != 0) != is_positive_token(token);
}

int Decoder::choose(const Vector& scores, Eigen::Index count, DecodedGoal& out) {
  int best = -1;
  for (Eigen::Index i = 0; i < count; ++i) {
    if (admitted_[static_cast<std::size_t>(i)] && (best < 0 || scores[i] > scores[best]))
      best = static_cast<int>(i);
  }
  if (best < 0) return -1;
  float sum = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    if (admitted_[static_cast<std::size_t>(i)]) sum += std::exp(scores[i] - scores[best]);
  }
  out.log_probability -= std::log(static_cast<double>(sum));
  ++out.choices;
  return best;
}

void Decoder::decode(Network& network, const EncodedWorld& world, DecodedGoal& out) {
  out.predicates.clear();
  out.log_probability = 0;
  out.choices = 0;
  const int n = world.objects, values = static_cast<int>(grammar_.values().size());
  admitted_.resize(std::max({at(n), at(values), at(kTokens)}));
  while (static_cast<int>(out.predicates.size()) < config_.max_predicates) {
    for (int token = 0; token < kTokens; ++token) {
      bool admitted = token == kStopToken;
      if (!admitted && (is_positive_token(token) ? config_.positive : config_.negative)) {
        for (int i = 0; i < n && !admitted; ++i) admitted = main_admitted(token, i, world, out);
      }
      admitted_[at(token)] = admitted;
    }
    DecodedPredicate next;
    next.token = choose(network.token_scores(), kTokens, out);
    if (next.token == kStopToken) return;
    for (int i = 0; i < n; ++i) admitted_[at(i)] = main_admitted(next.token, i, world, out);
    next.main = choose(network.main_scores(next.token), n, out);
    if (next.main < 0) return;
    const GoalRelation relation = relation_of_token(next.token);
    if (has_second_object(relation)) {
      for (int i = 0; i < n; ++i) admitted_[at(i)] = second_admitted(next.token, next.main, i, world, out);
      next.second = choose(network.second_scores(next.token, next.main), n, out);
      if (next.second < 0) return;
    }
    if (relation == GoalRelation::kState) {
      for (int v = 0; v < values; ++v)
        admitted_[at(v)] = value_admitted(next.token, next.main, v, world, out);
      next.value = choose(network.value_scores(next.token, next.main), values, out);
      if (next.value < 0) return;
    }
    out.predicates.push_back(next);
    network.advance(next.token, next.main, next.second, next.value);
  }
}

}  // namespace goalnet::inference::network
