// What spoken sentences have and written ones lack: endings run together, words thrown in, afterthoughts.
#pragma once

#include <string>
#include <vector>

namespace goalnet::inference {

class Language;

// "the kettle 's empty" -> "the kettle is empty"; "mum 's mug" -> "mum mug". See Endings::kKept of the
// tokenizer.
void resolve_endings(std::vector<std::string>& words, const Language& language);
// "id like" -> "i would like", "im thirsty" -> "i am thirsty".
void expand_contractions(std::vector<std::string>& words, const Language& language);
// "guests: two plates" -> "two plates"; "trash: the coke" -> "trash the coke"; else ":" becomes ",".
void resolve_headings(std::vector<std::string>& words, const Language& language);
// Adverbs that change nothing ("terribly", "kindly") and "please" in the middle of what it belongs to.
void drop_thrown_in(std::vector<std::string>& words, const Language& language);
// "what this coffee needs is chocolate" -> "this coffee needs chocolate".
void needs_first(std::vector<std::string>& words);
// "the stove is no place for a coke" -> "a coke should not be on the stove".
void no_places(std::vector<std::string>& words);
// "not the coke, the beer" -> "wish the beer".
void not_but(std::vector<std::string>& words);
// "I read the one on the shelf, bring me that book" -> "I read the book on the shelf, bring me the book on
// the shelf".
void name_the_one(std::vector<std::string>& words, const Language& language);
// "on the coffee table, snack table I mean" -> "on the coffee table, correction snack table".
void reasons_of_corrections(std::vector<std::string>& words);
void afterthoughts_first(std::vector<std::string>& words);
// "the salt, which should not be here, belongs on the counter" -> "the salt belongs on the counter".
void drop_relative_parts(std::vector<std::string>& words, const Language& language);
// "one more thing: the salt" -> "wish the salt"; "one last thing, the tap is on" -> "the tap is on".
void last_requests(std::vector<std::string>& words, const Language& language);
// "a glass of water would do" -> "wish a glass of water".
void wishes_first(std::vector<std::string>& words);
// "ensure the salt stood on the counter again" (what "it would be nice if ..." became) -> "ensure the salt is
// on the counter"; "I wish the tv was on" -> "ensure the tv is on".
void wished_past(std::vector<std::string>& words);
// "wish the fork to be placed in the bowl and the spoon to be placed in the mug" -> "..., wish the spoon
// ...".
void repeat_the_wish(std::vector<std::string>& words, const Language& language);
// ", ," and ", ." where something between fell away.
void join_pauses(std::vector<std::string>& words);

}  // namespace goalnet::inference
