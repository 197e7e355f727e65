#include <algorithm>
#include <set>

#include "components/scene/load_parts.h"

namespace goalnet::scene {
namespace {

class Checker {
 public:
  Checker(const Scene& scene, YamlReader& root) : scene_(scene), root_(root) {
    for (const auto& object : scene.objects) objects_.push_back(object.name);
    for (const auto& fixture : scene.fixtures) fixtures_.push_back(fixture.name);
    for (const auto& region : scene.regions) regions_.push_back(region.name);
    for (const auto& fixture : scene.fixtures) {
      for (const auto& part : fixture.parts) {
        parts_.push_back(part.name);
        joints_.push_back(part.joint.name);
      }
    }
  }

  void unique(const std::vector<std::string>& names, const std::string& key, const std::string& what) {
    std::set<std::string> seen;
    for (const auto& name : names) {
      if (!seen.insert(name).second)
        root_.mistake_at(key, what + " '" + name + "' is defined twice; rename one");
    }
  }

  void known(const std::string& name, const std::vector<std::string>& names, const std::string& key,
             const std::string& where, const std::string& what) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    const std::string near = nearest_word(name, names);
    root_.mistake_at(key, where + " names the unknown " + what + " '" + name + "'" +
                              (near.empty() ? "" : "; did you mean '" + near + "'?"));
  }

  void run() {
    unique(objects_, "objects", "object");
    unique(fixtures_, "fixtures", "fixture");
    unique(parts_, "fixtures", "part");
    unique(joints_, "fixtures", "joint");
    unique(regions_, "regions", "region");
    for (const auto& region : scene_.regions) {
      known(region.fixture, fixtures_, "regions", "region '" + region.name + "'", "fixture");
      if (!region.door.empty()) known(region.door, parts_, "regions", "region '" + region.name + "'", "part");
    }
    rules();
  }

 private:
  void facts(const std::vector<Predicate>& list, const std::string& where) {
    for (const auto& fact : list) subject(fact, where);
  }
  void subject(const Predicate& fact, const std::string& where) {
    if (fact.relation != "state" || fact.object.empty()) {
      root_.mistake_at("rules",
                       where + " uses " + to_string(fact) + "; only (state subject value) is possible here");
    } else {
      known(fact.subject, scene_.symbols, "rules", where, "symbol");
    }
  }

  void rules() {
    const DeviceRules& rules = scene_.rules;
    for (const auto& rule : rules.joint_facts) {
      known(rule.joint, joints_, "rules", "a rule in joint_facts", "joint");
      subject(rule.fact, "a rule in joint_facts");
    }
    for (const auto& rule : rules.buttons) {
      if (rule.object.empty()) {
        known(rule.joint, joints_, "rules", "a rule in buttons", "joint");
      } else {
        known(rule.object, objects_, "rules", "a rule in buttons", "object");
      }
      known(rule.subject, scene_.symbols, "rules", "a rule in buttons", "symbol");
      facts(rule.when, "a rule in buttons");
      facts(rule.unless, "a rule in buttons");
    }
    for (const auto& rule : rules.clears) {
      facts(rule.when, "a rule in clears");
      facts(rule.clears, "a rule in clears");
    }
    for (const auto& rule : rules.fills) {
      known(rule.fixture, fixtures_, "rules", "a rule in fills", "fixture");
      if (!rule.part.empty()) known(rule.part, parts_, "rules", "a rule in fills", "part");
      facts(rule.when, "a rule in fills");
    }
    for (const auto& rule : rules.regions) {
      known(rule.region, regions_, "rules", "a rule in regions", "region");
      facts(rule.when, "a rule in regions");
      facts(rule.unless, "a rule in regions");
    }
    for (const auto& rule : rules.contacts) {
      if (!rule.object.empty()) known(rule.object, objects_, "rules", "a rule in contacts", "object");
      if (!rule.receiver.empty()) known(rule.receiver, objects_, "rules", "a rule in contacts", "object");
    }
    for (const auto& rule : rules.tears) known(rule.object, objects_, "rules", "a rule in tears", "object");
    facts(scene_.initial_facts, "initial_facts");
  }

  const Scene& scene_;
  YamlReader& root_;
  std::vector<std::string> objects_, fixtures_, regions_, parts_, joints_;
};

}  // namespace

void check_references(const Scene& scene, YamlReader& root) { Checker(scene, root).run(); }

}  // namespace goalnet::scene
