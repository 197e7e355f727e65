// (:types …)
#include <algorithm>

#include "components/planner/domain_parser.h"
#include "components/planner/type_hierarchy.h"

namespace goalnet::planner {
namespace {

constexpr std::size_t kMostTypes = 4096;

}  // namespace

// "a b - c (…)": parents may be declared later, or not at all (then they are below object).
bool DomainParser::types(const Token& section_word) {
  if (!once(&seen_types_, section_word)) return false;
  struct Declared {
    Token name;
    std::vector<Token> parents;
  };
  std::vector<Declared> declared;
  std::size_t untyped = 0;
  while (!failed() && peek().kind != Token::Kind::kClose) {
    Token word;
    if (!expect_word("a type", &word)) return false;
    if (word.text != "-") {
      if (!check_name(word, "a type")) return false;
      declared.push_back({word, {}});
      continue;
    }
    if (untyped == declared.size()) return fail_at(word.offset, "'-' follows no type");
    std::vector<Token> parents;
    if (peek().kind == Token::Kind::kOpen) {
      next();
      if (!expect_word("'either'", &word)) return false;
      if (!is(word, "either"))
        return fail_at(word.offset, "expected (either TYPE ...), found " + quoted(word));
      while (!failed() && peek().kind == Token::Kind::kWord) parents.push_back(next());
      if (!expect_close("(either ...)")) return false;
      if (parents.empty()) return fail_at(word.offset, "(either) names no type");
    } else {
      if (!expect_word("a type", &word)) return false;
      parents.push_back(word);
    }
    for (; untyped < declared.size(); ++untyped) declared[untyped].parents = parents;
  }
  if (!expect_close(":types")) return false;
  std::vector<std::uint8_t> defined = {0};
  std::vector<std::vector<TypeId>> parents(1);
  for (const Declared& entry : declared) {
    const TypeId id = domain_.types.add(entry.name.text);
    parents.resize(static_cast<std::size_t>(domain_.types.size()));
    defined.resize(parents.size());
    const bool again = id != 0 && defined[static_cast<std::size_t>(id)] != 0;
    bool adds = false;
    defined[static_cast<std::size_t>(id)] = 1;
    for (const Token& parent : entry.parents) {
      const TypeId above = domain_.types.add(parent.text);
      parents.resize(static_cast<std::size_t>(domain_.types.size()));
      defined.resize(parents.size());
      if (id == 0 && above == 0) continue;  // "object - object" is harmless
      auto& mine = parents[static_cast<std::size_t>(id)];
      if (std::find(mine.begin(), mine.end(), above) != mine.end()) continue;
      mine.push_back(above);
      adds = true;
    }
    // A type below two others is sometimes written as two declarations; one that says nothing new is a slip.
    if (again && !adds)
      return fail_at(entry.name.offset, "type " + quoted(entry.name) + " is declared twice");
    if (parents.size() > kMostTypes) {
      return fail_at(entry.name.offset, "more than " + std::to_string(kMostTypes) + " types");
    }
  }
  return close_types(parents, declared.empty() ? section_word : declared.front().name);
}

bool DomainParser::close_types(const std::vector<std::vector<TypeId>>& parents, const Token& where) {
  const auto circular = find_ancestors(parents, &domain_.ancestors);
  if (!circular) return true;
  return fail_at(where.offset,
                 "type '" + domain_.types.name(*circular) + "' is above itself: the types form a cycle");
}

}  // namespace goalnet::planner
