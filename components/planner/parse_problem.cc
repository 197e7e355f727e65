#include <charconv>

#include "components/planner/parser.h"

namespace goalnet::planner {
namespace {

constexpr std::int32_t kMostObjects = 4'000'000;

class ProblemParser : public Parser {
 public:
  ProblemParser(std::string_view text, std::string_view filename, const Domain& domain,
                const std::stop_token& stop)
      : Parser(text, filename, stop), domain_(domain), problem_(domain) {}

  Expected<Problem> parse() {
    if (!failed()) read();
    if (failed()) return tl::unexpected(error());
    problem_.arena() = std::move(arena_);
    return std::move(problem_);
  }

 private:
  bool read() {
    if (!expect_header("problem", &problem_.name)) return false;
    bool seen_domain = false, seen_objects = false, seen_init = false, seen_goal = false, seen_metric = false;
    while (!failed() && peek().kind == Token::Kind::kOpen) {
      next();
      Token word;
      if (!expect_word("a section like :init", &word)) return false;
      if (!is(word, ":domain") && !is(word, ":requirements") && !seen_domain) {
        return fail_at(word.offset, "(:domain NAME) must come first, found " + quoted(word));
      }
      bool good = false;
      if (is(word, ":domain")) {
        good = once(&seen_domain, word) && read_domain_name();
      } else if (is(word, ":requirements")) {
        while (peek().kind == Token::Kind::kWord) next();
        good = expect_close(":requirements");
      } else if (is(word, ":objects")) {
        good = once(&seen_objects, word) && objects();
      } else if (is(word, ":init")) {
        good = once(&seen_init, word) && init();
      } else if (is(word, ":goal")) {
        Scope scope{&problem_.goal_slots, {}};
        good = once(&seen_goal, word) && formula(domain_, &problem_, scope, 0, &problem_.goal) &&
               expect_close(":goal");
      } else if (is(word, ":metric")) {
        good = once(&seen_metric, word) && metric();
      } else if (is(word, ":length")) {  // a hint of old problem files
        good = skip_rest();
      } else if (is(word, ":constraints")) {
        return fail_at(word.offset, "trajectory constraints (:constraints) are not supported");
      } else {
        return fail_at(word.offset,
                       "unknown section " + quoted(word) +
                           did_you_mean(word.text, {":domain", ":objects", ":init", ":goal", ":metric"}));
      }
      if (!good) return false;
    }
    if (!expect_close("the problem") || !expect_end()) return false;
    if (!seen_domain) return fail_at(0, "the problem has no (:domain NAME)");
    if (!seen_goal) return fail_at(0, "the problem has no (:goal ...)");
    return true;
  }

  bool once(bool* seen, const Token& word) {
    if (*seen) return fail_at(word.offset, "a second section " + quoted(word));
    *seen = true;
    return true;
  }

  bool read_domain_name() {
    Token name;
    if (!expect_word("the domain's name", &name)) return false;
    if (!equal_ignoring_case(name.text, domain_.name)) {
      return fail_at(name.offset, "the problem is for domain " + quoted(name) + ", but this domain is '" +
                                      domain_.name + "'");
    }
    return expect_close(":domain");
  }

  bool objects() {
    TypedNames names;
    if (!typed_list(domain_, false, "an object", &names) || !expect_close(":objects")) return false;
    for (const TypedName& entry : names) {
      if (stop_asked()) return false;
      if (entry.types.size() > 1)
        return fail_at(entry.offset, "an object has one type; declare a type below both");
      const ObjectId known = problem_.find_object(entry.name);
      if (known != SymbolTable::kNone) {
        // Repeating a constant of the domain with the same type is common and harmless.
        if (known < domain_.constants.size() && problem_.object_type(known) == entry.types.front()) continue;
        return fail_at(entry.offset, "object '" + std::string(entry.name) + "' is declared twice");
      }
      if (problem_.object_count() >= kMostObjects) {
        return fail_at(entry.offset, "more than " + std::to_string(kMostObjects) + " objects");
      }
      problem_.add_object(entry.name, entry.types.front());
    }
    return true;
  }

  bool init() {
    while (!failed() && peek().kind != Token::Kind::kClose) {
      Token name;
      if (!expect_open("a fact") || !expect_word("a predicate", &name)) return false;
      if (name.text == "=") {
        if (!value()) return false;
        continue;
      }
      const bool negated = is(name, "not");
      if (negated && (!expect_open("a fact") || !expect_word("a predicate", &name))) return false;
      if (is(name, "at") && peek().kind == Token::Kind::kWord && !peek().text.empty() &&
          peek().text.front() >= '0' && peek().text.front() <= '9') {
        return fail_at(name.offset, "timed facts (:timed-initial-literals) are not supported");
      }
      PredicateId predicate = 0;
      const Scope nothing{&problem_.goal_slots, {}};
      arguments_.clear();
      if (!find_predicate(domain_, name, &predicate) ||
          !atom_arguments(domain_, &problem_, nothing, name,
                          domain_.predicate_schemas[static_cast<std::size_t>(predicate)].parameters,
                          &arguments_)) {
        return false;
      }
      if (negated) {  // closed world: says nothing new
        if (!expect_close("'not'")) return false;
        continue;
      }
      if (domain_.is_derived(predicate))
        return fail_at(name.offset, quoted(name) + " is derived; it cannot be given");
      ids_.clear();
      for (const Term argument : arguments_) ids_.push_back(argument.value);
      problem_.initial.add(predicate, ids_.data(), ids_.size());
    }
    return expect_close(":init");
  }

  // After "(=": "(function arguments) number)".
  bool value() {
    Token name, number;
    if (!expect_open("a function") || !expect_word("a function", &name)) return false;
    const std::int32_t function = domain_.functions.find(name.text);
    if (function == SymbolTable::kNone) {
      return fail_at(name.offset, "unknown function " + quoted(name) +
                                      did_you_mean(name.text, domain_.functions.first_names()));
    }
    arguments_.clear();
    const Scope nothing{&problem_.goal_slots, {}};
    if (!atom_arguments(domain_, &problem_, nothing, name,
                        domain_.function_schemas[static_cast<std::size_t>(function)].parameters,
                        &arguments_) ||
        !expect_word("a number", &number)) {
      return false;
    }
    std::string_view text = number.text;
    if (const std::size_t point = text.find('.'); point != std::string_view::npos) {
      if (text.find_first_not_of('0', point + 1) == std::string_view::npos) text = text.substr(0, point);
    }
    std::int64_t amount = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), amount);
    if (code != std::errc{} || end != text.data() + text.size() || amount < 0 || amount > 1'000'000'000) {
      return fail_at(number.offset,
                     "a value must be a whole number from 0 to 1000000000, not " + quoted(number));
    }
    ids_.clear();
    for (const Term argument : arguments_) ids_.push_back(argument.value);
    bool is_new = false;
    const std::int32_t index = problem_.cost_atoms.add(function, ids_.data(), ids_.size(), &is_new);
    if (is_new) problem_.cost_values.push_back(amount);
    problem_.cost_values[static_cast<std::size_t>(index)] = amount;
    return expect_close("'='");
  }

  bool metric() {
    Token word;
    if (!expect_word("'minimize'", &word)) return false;
    if (!is(word, "minimize")) {
      return fail_at(word.offset, "only (:metric minimize (total-cost)) is supported, not " + quoted(word));
    }
    if (peek().kind == Token::Kind::kWord) {
      const Token name = next();
      if (!is(name, "total-time") && !is(name, "total-cost")) {
        return fail_at(name.offset, "only (total-cost) can be minimised, not " + quoted(name));
      }
      problem_.minimise_cost = is(name, "total-cost");
      return expect_close(":metric");
    }
    if (!expect_open("(total-cost)") || !expect_word("total-cost", &word)) return false;
    if (!is(word, "total-cost") && !is(word, "total-time")) {
      return fail_at(
          word.offset,
          "only (total-cost) can be minimised (numeric fluents are not supported), not " + quoted(word));
    }
    problem_.minimise_cost = is(word, "total-cost");
    return expect_close("(total-cost)") && expect_close(":metric");
  }

  const Domain& domain_;
  Problem problem_;
  TermList arguments_;
  std::vector<ObjectId> ids_;
};

}  // namespace

Expected<Problem> parse_problem(std::string_view text, std::string_view filename, const Domain& domain,
                                const std::stop_token& stop) {
  return ProblemParser(text, filename, domain, stop).parse();
}

Expected<Problem> load_problem(const std::string& path, const Domain& domain, const std::stop_token& stop) {
  const auto text = read_text_file(path, stop);
  if (!text) return tl::unexpected(text.error());
  return parse_problem(text->text, path, domain, stop);
}

}  // namespace goalnet::planner
