// Reads a YAML map key by key and collects every mistake with its file and line, so that one look mends a
// file.
#pragma once

#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>
#include <Eigen/Core>

#include "components/core/outcome.h"
#include "components/core/predicate.h"

namespace goalnet::scene {

// Mistakes found so far in one or several files. Keeps the first 20 texts and counts the rest.
class Mistakes {
 public:
  void add(const std::string& file, const YAML::Mark& mark, const std::string& what);
  bool none() const { return count_ == 0; }
  // One kInvalidRequest error with a line per mistake.
  Error error() const;

 private:
  std::vector<std::string> texts_;
  std::size_t count_ = 0;
};

// Limits on what is read, so that a hostile file costs neither memory nor time.
inline constexpr std::size_t kMaxFileBytes = 4u << 20;
inline constexpr std::size_t kMaxListLength = 10'000;

// Reads and parses a file; what cannot be read at all is an error at once.
Expected<YAML::Node> read_yaml_file(const std::string& path);
// The same from memory; `name` stands for the file in messages.
Expected<YAML::Node> read_yaml_text(const std::string& text, const std::string& name);

// A map of the file. Every getter notes a mistake and returns something harmless when the key is missing or
// wrong.
class YamlReader {
 public:
  YamlReader(YAML::Node node, std::string file, Mistakes& mistakes);

  bool has(const std::string& key);
  double number(const std::string& key, double min, double max);
  double number(const std::string& key, double min, double max, double otherwise);
  bool flag(const std::string& key, bool otherwise);
  std::string text(const std::string& key);
  std::string text(const std::string& key, const std::string& otherwise);
  // A word out of `choices`.
  std::string choice(const std::string& key, const std::vector<std::string>& choices,
                     const std::optional<std::string>& otherwise = {});
  std::vector<double> numbers(const std::string& key, std::size_t length, double min, double max,
                              const std::optional<std::vector<double>>& otherwise = {});
  Eigen::Vector3d vector3(const std::string& key, const std::optional<Eigen::Vector3d>& otherwise = {});
  // Empty when missing.
  std::vector<std::string> texts(const std::string& key);
  std::vector<Predicate> predicates(const std::string& key);
  // Lists of maps; empty when missing.
  std::vector<YamlReader> maps(const std::string& key);
  // Pairs (name, map) of a map of maps in the order of the file; empty when missing.
  std::vector<std::pair<std::string, YamlReader>> named_maps(const std::string& key);
  std::optional<YamlReader> map(const std::string& key);

  // Notes every key that no getter asked for: typing errors.
  void finish();
  void mistake(const std::string& what);
  void mistake_at(const std::string& key, const std::string& what);
  const std::string& file() const { return file_; }
  Mistakes& mistakes() { return *mistakes_; }

 private:
  YAML::Node find(const std::string& key, bool required);
  double number_of(const YAML::Node& node, const std::string& key, double min, double max);
  std::optional<std::string> scalar_of(const YAML::Node& node, const std::string& key);

  YAML::Node node_;
  std::string file_;
  Mistakes* mistakes_;
  std::set<std::string> asked_;
};

// The candidate nearest to `word` by edit distance, or nothing when none is near.
std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace goalnet::scene
