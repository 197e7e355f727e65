#include "components/goalnet/training/vocabulary.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>

#include <Eigen/Eigenvalues>
#include <nlohmann/json.hpp>

#include "components/goalnet/tokenizer.h"

namespace goalnet::inference::training {
namespace {

using network::GoalRelation;

// Rows as the coordinates along the axes of largest variance; the mean row becomes length 1.
network::Matrix reduce(const Eigen::MatrixXd& rows, int size) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(rows.transpose() * rows);
  const Eigen::Index kept = std::min<Eigen::Index>(size, rows.cols());
  Eigen::MatrixXd basis = axes.eigenvectors().rightCols(kept).rowwise().reverse();
  for (Eigen::Index axis = 0; axis < kept;
       ++axis) {  // an axis has no sign: fix one, so that files are repeatable
    Eigen::Index largest = 0;
    basis.col(axis).cwiseAbs().maxCoeff(&largest);
    if (basis(largest, axis) < 0) basis.col(axis) *= -1;
  }
  Eigen::MatrixXd reduced = Eigen::MatrixXd::Zero(rows.rows(), size);
  reduced.leftCols(kept) = rows * basis;
  const Eigen::Index used = (reduced.rowwise().norm().array() > 0).count();
  if (used > 0) reduced *= static_cast<double>(used) / reduced.rowwise().norm().sum();
  return reduced.cast<float>();
}

struct Counts {
  std::set<std::string> classes, values;
  std::map<std::string, std::map<std::string, float>> senses;
};

Counts count(const std::vector<Episode>& episodes) {
  Counts counts;
  for (const Episode& episode : episodes) {
    for (const WorldState& state : episode.states) {
      for (const std::string& name : state.objects)
        counts.classes.insert(network::split_name(name).class_name);
      for (const Predicate& fact : state.facts) {
        if (fact.relation == "state") counts.values.insert(fact.object);
      }
    }
    for (const Goal& goal : episode.goals) {
      for (const auto* facts : {&goal.positive, &goal.negative}) {
        for (const Predicate& fact : *facts) {
          if (fact.relation == "state") counts.values.insert(fact.object);
        }
      }
    }
    for (const auto& [word, objects] : episode.grounding) {
      std::set<std::string> classes;
      for (const std::string& name : objects) classes.insert(network::split_name(name).class_name);
      for (const std::string& name : classes) {
        counts.senses[word][name] += 1.0F / static_cast<float>(classes.size());
      }
    }
  }
  // A word grounded once proves little: one half is added to what it might have meant otherwise.
  for (auto& [word, meanings] : counts.senses) {
    float sum = 0.5F;
    for (const auto& [name, weight] : meanings) sum += weight;
    for (auto& [name, weight] : meanings) weight /= sum;
  }
  return counts;
}

void learn_grammar(const std::vector<Episode>& episodes, const network::Lexicon& lexicon,
                   network::Grammar& grammar) {
  const auto class_of = [&](const std::string& name) {
    return lexicon.class_of(network::split_name(name).class_name);
  };
  const auto learn = [&](const Predicate& fact) {
    const int relation = network::relation_id(fact.relation);
    if (relation < 0) return;
    const auto r = static_cast<GoalRelation>(relation);
    const std::string& main = network::main_argument(fact);
    if (main == "Robot") return;
    grammar.allow(r, class_of(main));
    if (network::has_second_object(r) && fact.object != fact.subject)
      grammar.allow_second(r, class_of(fact.object));
    if (r == GoalRelation::kState) grammar.allow_value(class_of(main), grammar.value(fact.object));
  };
  for (const Episode& episode : episodes) {
    for (const WorldState& state : episode.states) {
      for (const Predicate& fact : state.facts) learn(fact);
    }
    for (const Goal& goal : episode.goals) {
      for (const Predicate& fact : goal.positive) learn(fact);
      for (const Predicate& fact : goal.negative) learn(fact);
    }
  }
}

// The tables of the paper's constants.json, where it is there: IN_obj1 and so on, and the states of each
// object.
Expected<void> read_constants(const std::filesystem::path& path, const network::Lexicon& lexicon,
                              network::Grammar& grammar) {
  std::ifstream file(path);
  if (!file) return {};
  try {
    const auto json = nlohmann::json::parse(file);
    const auto class_of = [&](const nlohmann::json& name) {
      return lexicon.class_of(network::split_name(name.get<std::string>()).class_name);
    };
    const auto each = [&](const char* key, auto use) {
      for (const auto& room : json.at(key)) {
        for (const auto& name : room) use(class_of(name));
      }
    };
    each("IN_obj1", [&](int c) { grammar.allow(GoalRelation::kIn, c); });
    each("IN_obj2", [&](int c) { grammar.allow_second(GoalRelation::kIn, c); });
    each("ON_obj1", [&](int c) { grammar.allow(GoalRelation::kOn, c); });
    each("ON_obj2", [&](int c) { grammar.allow_second(GoalRelation::kOn, c); });
    each("Grasp_obj2", [&](int c) { grammar.allow(GoalRelation::kGrasping, c); });
    each("state_obj1", [&](int c) { grammar.allow(GoalRelation::kState, c); });
    for (const auto& [name, values] : json.at("all_object_states").items()) {
      for (const auto& value : values)
        grammar.allow_value(class_of(name), grammar.value(value.get<std::string>()));
    }
  } catch (const nlohmann::json::exception& error) {
    return fail(Outcome::kInvalidRequest, path.string() + " cannot be read: " + error.what());
  }
  return {};
}

}  // namespace

Expected<WordVectors> read_word_vectors(const std::vector<std::filesystem::path>& files) {
  WordVectors vectors;
  std::size_t size = 0;
  for (const auto& path : files) {
    std::ifstream file(path);
    if (!file) continue;
    const auto refuse = [&path](const std::string& why) {
      return fail(Outcome::kInvalidRequest, path.string() + " " + why);
    };
    try {
      const auto json = nlohmann::json::parse(file);
      for (const auto& [name, numbers] : json.items()) {
        if (numbers.is_null()) continue;  // a word that was looked up in vain
        auto vector = numbers.get<std::vector<float>>();
        if (size == 0) size = vector.size();
        if (vector.size() != size || size == 0) return refuse("has vectors of different lengths");
        // Object names ("Loveseat_1") stand for their class when that is one word.
        const network::SplitName split = network::split_name(name);
        std::string word;
        for (const char c : split.class_name)
          word.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
        if (split.words.size() == 1) vectors.emplace(word, std::move(vector));
      }
    } catch (const nlohmann::json::exception& error) {
      return refuse(std::string("cannot be read: ") + error.what());
    }
  }
  return vectors;
}

Expected<Vocabulary> make_vocabulary(const std::vector<Episode>& episodes, const WordVectors& vectors,
                                     int size, const std::filesystem::path& constants) {
  Counts counts = count(episodes);
  std::set<std::string> words;
  for (const auto& [word, vector] : vectors) words.insert(word);
  for (const Episode& episode : episodes) {
    const auto tokens = tokenize(episode.sentence);
    if (!tokens) return tl::unexpected(tokens.error());
    words.insert(tokens->begin(), tokens->end());
  }
  for (const std::string& name : counts.classes) {
    const auto split = network::split_name(name).words;
    words.insert(split.begin(), split.end());
  }
  const Eigen::Index width =
      vectors.empty() ? size : static_cast<Eigen::Index>(vectors.begin()->second.size());
  Eigen::MatrixXd table = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(words.size()), width);
  Eigen::Index row = 0;
  for (const std::string& word : words) {
    const auto found = vectors.find(word);
    if (found != vectors.end())
      table.row(row) = Eigen::Map<const Eigen::VectorXf>(found->second.data(), width).cast<double>();
    const double length = table.row(row).norm();
    if (length > 0) table.row(row) /= length;
    ++row;
  }
  network::Lexicon lexicon({words.begin(), words.end()}, {counts.classes.begin(), counts.classes.end()},
                           std::move(counts.senses));
  if (counts.values.empty()) counts.values.insert("none");
  network::Grammar grammar({counts.values.begin(), counts.values.end()}, counts.classes.size());
  learn_grammar(episodes, lexicon, grammar);
  if (auto read = read_constants(constants, lexicon, grammar); !read) return tl::unexpected(read.error());
  return Vocabulary{std::move(lexicon), std::move(grammar), reduce(table, size)};
}

}  // namespace goalnet::inference::training
