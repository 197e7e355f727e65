// Ways of saying the same that no fixed phrase tells (those are the rewrites of
// config/language/english.json): made equal before any grammar.
#pragma once

#include <string>
#include <vector>

namespace goalnet::inference {

class Language;

// Before rewriting: intensifiers dropped, "my wife wants" as "I want", polite ifs, tools by what they are
// for.
void say_plainly(std::vector<std::string>& text, const Language& language);
// "my wife needs the salt" -> "i need the salt" (who_wants.cc).
void speak_for_others(std::vector<std::string>& text, const Language& language);
// After rewriting: a wish and the thing wished for in one sentence; the "." at both ends taken away.
void join_wishes(std::vector<std::string>& text);

}  // namespace goalnet::inference
