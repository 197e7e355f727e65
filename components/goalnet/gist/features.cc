#include "components/goalnet/gist/features.h"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <string_view>

namespace goalnet::inference::gist {
namespace {

constexpr std::size_t kLongestPattern = 10;  // words

class Collector {
 public:
  Collector(const Message& message, const Request& request)
      : message_(message),
        request_(request),
        ask_(std::to_string(static_cast<int>(request.ask)) + (request.view == 0 ? "" : " rewritten")) {}

  std::vector<std::uint32_t> collect() {
    add({"ask"});
    add({"class", request_.thing_class});
    add({"classes", request_.thing_class, request_.other_class});
    add({"holds", request_.holds ? "1" : "0"});
    add({"named", number(message_.named.size(), 4)});
    if (request_.number > 0) numbered();
    if (request_.other >= 0) between();
    if (request_.thing >= 0 || request_.ask == Ask::kChannel) around();
    if (request_.other < 0) place_besides();
    std::set<std::string> all(message_.words.begin(), message_.words.end());
    all.insert(message_.sorts.begin(), message_.sorts.end());
    for (const std::string& word : all) add({"word", word});
    if (request_.thing >= 0) pattern();
    return std::move(result_);
  }

 private:
  static std::string number(std::size_t n, std::size_t most) { return std::to_string(std::min(n, most)); }

  void add(std::initializer_list<std::string_view> parts) {
    std::uint32_t hash = 2166136261u;
    const auto mix = [&](std::string_view text) {
      for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
      hash = (hash ^ 0x1fu) * 16777619u;
    };
    mix(ask_);
    for (const std::string_view part : parts) mix(part);
    hash ^= hash >> 15;
    result_.push_back(hash % kFeatures);
  }
  // The word and what sort of word it is.
  void add_word(std::string_view where, std::string_view order, std::size_t i) {
    add({where, order, message_.words[i]});
    add({where, order, message_.sorts[i], "sort"});
  }
  std::string joined(std::size_t from, std::size_t to) const {
    std::string text;
    for (std::size_t i = from; i < to; ++i) text += message_.words[i] + " ";
    return text;
  }

  // A burner's number is said beside its name, or that of another is.
  void numbered() {
    if (request_.thing < 0) return;
    const Named& name = message_.named[static_cast<std::size_t>(request_.thing)];
    bool this_one = false, any = false;
    for (std::size_t i = name.begin - std::min<std::size_t>(name.begin, 2);
         i < std::min(name.end + 2, message_.words.size()); ++i) {
      const int said = small_number(message_.words[i]);
      this_one = this_one || said == request_.number;
      any = any || said > 0;
    }
    const std::string_view told = this_one ? "this" : any ? "other" : "none";
    add({"number", told});
    add({"number", told, request_.holds ? "holds" : ""});
  }

  // What stands between the thing and where it goes.
  void between() {
    const Named& thing = message_.named[static_cast<std::size_t>(request_.thing)];
    const Named& other = message_.named[static_cast<std::size_t>(request_.other)];
    const bool forward = thing.begin < other.begin;
    const std::string_view order = forward ? "forward" : "backward";
    const std::size_t from = forward ? thing.end : other.end, to = forward ? other.begin : thing.begin;
    const auto first = message_.words.begin() + static_cast<std::ptrdiff_t>(from);
    const auto last = message_.words.begin() + static_cast<std::ptrdiff_t>(std::max(from, to));
    const bool stop = std::find(first, last, ".") != last;
    const auto inside = std::count_if(message_.named.begin(), message_.named.end(), [&](const Named& name) {
      return name.begin >= from && name.end <= to;
    });
    add({"order", order});
    add({"inside", order, number(static_cast<std::size_t>(inside), 3), stop ? "stop" : ""});
    add({"apart", order, number((to - std::min(from, to)) / 2, 5)});
    if (to <= from + 6) add({"phrase", order, joined(from, to)});
    for (std::size_t i = from; i < to; ++i) add_word("between", order, i);
    for (std::size_t i = other.begin - std::min<std::size_t>(other.begin, 3); i < other.begin; ++i)
      add_word("before other", order, i);
    if (other.begin > 0) add_word("next before other", order, other.begin - 1);
    for (std::size_t i = other.end; i < std::min(other.end + 2, message_.words.size()); ++i)
      add_word("after other", order, i);
  }

  // The words beside the thing, and those of its sentence.
  void around() {
    std::size_t begin = request_.at, end = request_.at + 1;
    if (request_.thing >= 0) {
      const Named& name = message_.named[static_cast<std::size_t>(request_.thing)];
      begin = name.begin, end = name.end;
      add({"may mean", number(name.classes.size(), 3)});
      add({"which", number(static_cast<std::size_t>(request_.thing), 3)});
    }
    const std::size_t size = message_.words.size();
    for (std::size_t d = 0; d < std::min<std::size_t>(begin, 4); ++d)
      add_word("before", number(d, 2), begin - 1 - d);
    for (std::size_t d = 0; d < std::min<std::size_t>(size - end, 4); ++d)
      add_word("after", number(d, 2), end + d);
    add({"two before", joined(begin - std::min<std::size_t>(begin, 2), begin)});
    add({"three before", joined(begin - std::min<std::size_t>(begin, 3), begin)});
    add({"two after", joined(end, std::min(end + 2, size))});
    std::size_t from = begin, to = end;
    while (from > 0 && message_.words[from - 1] != ".") --from;
    while (to < size && message_.words[to] != ".") ++to;
    std::set<std::string> sentence;
    for (std::size_t i = from; i < to; ++i) sentence.insert({message_.words[i], message_.sorts[i]});
    for (const std::string& word : sentence) add({"sentence", word});
    std::string_view verb = "none";
    for (std::size_t i = from; i < begin; ++i)
      if (message_.sorts[i].starts_with("verb")) verb = message_.sorts[i];
    add({"verb", verb});
    add({"verb", verb, request_.thing_class});
  }

  // The sentence with its names left out: "put X in Y".
  void pattern() {
    const Named& thing = message_.named[static_cast<std::size_t>(request_.thing)];
    std::size_t from = thing.begin, to = thing.end;
    while (from > 0 && message_.words[from - 1] != ".") --from;
    while (to < message_.words.size() && message_.words[to] != ".") ++to;
    if (to - from > kLongestPattern) return;
    std::string text;
    for (std::size_t i = from; i < to;) {
      const auto name = std::find_if(message_.named.begin(), message_.named.end(),
                                     [&](const Named& one) { return one.begin == i; });
      const int index = static_cast<int>(name - message_.named.begin());
      if (name == message_.named.end()) {
        text += message_.words[i++] + " ";
        continue;
      }
      text += index == request_.thing ? "X " : index == request_.other ? "Y " : "Z ";
      i = name->end;
    }
    add({"pattern", text});
  }

  // Whether anything else could be where it goes.
  void place_besides() {
    const bool place = std::any_of(message_.sorts.begin(), message_.sorts.end(),
                                   [](const std::string& sort) { return sort == "place"; });
    add({"place", place ? "1" : "0"});
  }

  const Message& message_;
  const Request& request_;
  const std::string ask_;
  std::vector<std::uint32_t> result_;
};

}  // namespace

std::vector<std::uint32_t> features(const Message& message, const Request& request) {
  return Collector(message, request).collect();
}

}  // namespace goalnet::inference::gist
