#include "components/goalnet/network/world_encoder.h"

#include <algorithm>

#include "components/goalnet/network/index.h"

namespace goalnet::inference::network {
namespace {

constexpr float kSimilarityFloor = 0.3F;
constexpr float kSenseFloor = 0.05F;

}  // namespace

int EncodedSentence::known() const {
  return static_cast<int>(std::count_if(words.begin(), words.end(), [](int word) { return word >= 0; }));
}

WorldEncoder::WorldEncoder(const NetworkConfig& config, const Lexicon& lexicon, const Grammar& grammar,
                           const Matrix& vectors, NameTable& names)
    : config_(config), lexicon_(lexicon), grammar_(grammar), unit_vectors_(vectors), names_(names) {
  for (Eigen::Index row = 0; row < unit_vectors_.rows(); ++row) {
    const float length = unit_vectors_.row(row).norm();
    if (length > 0) unit_vectors_.row(row) /= length;
  }
}

Expected<void> WorldEncoder::encode(const EncodedSentence& sentence, std::span<const std::string> texts,
                                    const Grounding* grounding, const WorldState& state,
                                    std::span<const Goal> goals, EncodedWorld& out) {
  if (state.objects.size() > kMaxObjects) {
    return fail(Outcome::kInvalidRequest, "the world has " + std::to_string(state.objects.size()) +
                                              " objects; at most " + std::to_string(kMaxObjects) +
                                              " are admitted");
  }
  out.objects = static_cast<int>(state.objects.size());
  const std::size_t n = state.objects.size();
  index_.rebuild(state.objects);
  out.slot.resize(n);
  out.class_id.resize(n);
  out.edges.clear();
  for (auto* bits : {&out.mentioned, &out.held, &out.near, &out.graspable}) bits->assign(n, 0);
  out.value.assign(n * grammar_.values().size(), 0);
  scratch_.clear();
  mentions_.assign(n, Mention{});
  class_count_.assign(lexicon_.classes().size(), 0);
  for (std::size_t i = 0; i < n; ++i) {
    out.slot[i] = names_.slot(state.objects[i]);
    out.class_id[i] = names_.entry(out.slot[i]).class_id;
    if (out.class_id[i] >= 0) ++class_count_[at(out.class_id[i])];
  }
  for (int i = 0; i < out.objects; ++i) {
    const NameEntry& name = names_.entry(out.slot[at(i)]);
    add(i, kInstance0 + std::min(name.instance, 4), 1);
    if (name.class_id < 0) add(i, kUnknownClass, 1);
    if (name.class_id >= 0 && class_count_[at(name.class_id)] == 1) add(i, kOnlyOfItsClass, 1);
  }
  read_facts(state, out);
  read_goals(goals, out);
  if (config_.instance_grounding) {
    if (grounding != nullptr) read_grounding(texts, *grounding);
    match_words(sentence, out);
    bool any_grounded = false;
    for (const Mention& mention : mentions_) any_grounded |= mention.grounded;
    for (int i = 0; i < out.objects; ++i) {
      const Mention& m = mentions_[at(i)];
      if (m.grounded) {
        add(i, kGrounded, 1);
        add(i, kGroundedShare, m.grounded_share);
        add(i, kGroundedRank0 + std::min(m.grounded_rank, 3), 1);
      }
      if (m.sense > kSenseFloor) {
        add(i, kLexiconSense, m.sense);
        add(i, kLexiconRank0 + std::min(m.sense_rank, 3), 1);
      }
      if (m.full_name) add(i, kFullName, 1);
      if (m.partial_name) add(i, kPartialName, 1);
      if (m.similarity > kSimilarityFloor) add(i, kSimilarWord, m.similarity);
      const bool by_words = m.full_name || m.sense > kSenseFloor || m.similarity > 0.6F;
      out.mentioned[at(i)] = any_grounded ? m.grounded : by_words;
    }
  }
  write_items(out);
  return {};
}

void WorldEncoder::read_facts(const WorldState& state, EncodedWorld& out) {
  const std::size_t values = grammar_.values().size();
  for (const Predicate& fact : state.facts) {
    const int subject = index_.find(fact.subject);
    const bool by_robot = fact.subject == "Robot";
    if (fact.relation == "IsGraspable" || fact.relation == "IsSqueezeable") {
      if (subject < 0) continue;
      add(subject, fact.relation == "IsGraspable" ? kGraspable : kSqueezeable, 1);
      if (fact.relation == "IsGraspable") out.graspable[at(subject)] = 1;
    } else if (fact.relation == "state") {
      const int value = grammar_.value(fact.object);
      if (subject < 0 || value < 0) continue;
      add(subject, kFirstValue + value, 1);
      out.value[at(subject) * values + at(value)] = 1;
    } else if ((fact.relation == "Near" || fact.relation == "Grasping") && by_robot) {
      const int object = index_.find(fact.object);
      if (object < 0) continue;
      const bool held = fact.relation == "Grasping";
      add(object, held ? kHeld : kNearRobot, 1);
      (held ? out.held : out.near)[at(object)] = 1;
    } else if (fact.relation == "On" || fact.relation == "In") {
      const int object = index_.find(fact.object);
      const bool in = fact.relation == "In";
      if (subject < 0 || object < 0) continue;
      if (subject == object) continue;  // (On GarbageBin_1 GarbageBin_1) stands in many states
      // Where no demonstration puts anything, lying there says nothing: a real world reports (On X Counter_1)
      // for everything that nobody has moved yet.
      if (!grammar_.second_allowed(in ? GoalRelation::kIn : GoalRelation::kOn, out.class_id[at(object)]))
        continue;
      add(subject, in ? kInSomething : kOnSomething, 1);
      add(object, kCarriesSomething, 1);
      out.edges.push_back({object, subject, in ? 2 : 0});
      out.edges.push_back({subject, object, in ? 3 : 1});
    }
  }
}

void WorldEncoder::read_goals(std::span<const Goal> goals, EncodedWorld& out) {
  out.past.clear();
  out.first_past.assign(1, 0);
  for (std::size_t g = 0; g < goals.size(); ++g) {
    const bool last = g + 1 == goals.size();
    for (const bool positive : {true, false}) {
      if (!(positive ? config_.positive : config_.negative)) continue;
      for (const Predicate& fact : positive ? goals[g].positive : goals[g].negative) {
        const int relation = relation_id(fact.relation);
        if (relation < 0) continue;
        const auto r = static_cast<GoalRelation>(relation);
        const std::string& main = main_argument(fact);
        PastPredicate past{token_of(r, positive), names_.slot(main), -1, -1};
        if (has_second_object(r)) past.second_slot = names_.slot(fact.object);
        if (r == GoalRelation::kState) past.value = grammar_.value(fact.object);
        out.past.push_back(past);
        if (config_.temporal == TemporalContext::kNone) continue;
        if (const int object = index_.find(main); object >= 0) add(object, last ? kLastMain : kEverMain, 1);
        if (!has_second_object(r)) continue;
        if (const int object = index_.find(fact.object); object >= 0)
          add(object, last ? kLastSecond : kEverSecond, 1);
      }
    }
    out.first_past.push_back(static_cast<int>(out.past.size()));
  }
}

void WorldEncoder::read_grounding(std::span<const std::string> texts, const Grounding& grounding) {
  int rank = 0;
  const auto note = [&](const std::vector<std::string>& objects) {
    bool any = false;
    for (const std::string& name : objects) {
      const int object = index_.find(name);
      if (object < 0) continue;
      any = true;
      Mention& mention = mentions_[at(object)];
      mention.grounded_rank = mention.grounded ? mention.grounded_rank : rank;
      mention.grounded = true;
      mention.grounded_share = std::max(mention.grounded_share, 1.0F / static_cast<float>(objects.size()));
    }
    rank += any ? 1 : 0;
  };
  for (const std::string& text : texts) {
    const auto found = grounding.find(text);
    if (found != grounding.end()) note(found->second);
  }
  for (const auto& [word, objects] : grounding) {  // words spelled otherwise than in the sentence come last
    if (std::find(texts.begin(), texts.end(), word) == texts.end()) note(objects);
  }
}

void WorldEncoder::match_words(const EncodedSentence& sentence, const EncodedWorld& world) {
  // The senses of each word, in the order of the sentence: class -> when it was first meant.
  class_rank_.assign(lexicon_.classes().size(), -1);
  int rank = 0;
  for (const int word : sentence.words) {
    if (word < 0 || lexicon_.senses(word).empty()) continue;
    for (const WordSense& sense : lexicon_.senses(word)) {
      if (class_rank_[at(sense.class_id)] < 0) class_rank_[at(sense.class_id)] = rank;
    }
    ++rank;
  }
  for (int i = 0; i < world.objects; ++i) {
    Mention& mention = mentions_[at(i)];
    const NameEntry& name = names_.entry(world.slot[at(i)]);
    std::size_t found = 0;
    for (const int part : name.words) {
      found += std::find(sentence.words.begin(), sentence.words.end(), part) != sentence.words.end();
    }
    mention.full_name = found > 0 && found == name.word_count;
    mention.partial_name = found > 0 && found < name.word_count;
    for (const int word : sentence.words) {
      if (word < 0) continue;
      mention.similarity = std::max(mention.similarity, unit_vectors_.row(word).dot(name.unit));
    }
    if (name.class_id < 0 || class_rank_[at(name.class_id)] < 0) continue;
    mention.sense_rank = class_rank_[at(name.class_id)];
    for (const int word : sentence.words) {
      if (word < 0) continue;
      for (const WordSense& sense : lexicon_.senses(word)) {
        if (sense.class_id == name.class_id) mention.sense = std::max(mention.sense, sense.probability);
      }
    }
  }
}

void WorldEncoder::write_items(EncodedWorld& out) {
  // Counting sort by object; within an object the order of adding stays, so sums are the same every time.
  out.first_item.assign(at(out.objects) + 1, 0);
  for (const Scratch& entry : scratch_) ++out.first_item[at(entry.object) + 1];
  for (int i = 0; i < out.objects; ++i) out.first_item[at(i) + 1] += out.first_item[at(i)];
  out.items.resize(scratch_.size());
  class_rank_.assign(out.first_item.begin(), out.first_item.end());
  for (const Scratch& entry : scratch_) out.items[at(class_rank_[at(entry.object)]++)] = entry.item;
}

}  // namespace goalnet::inference::network
