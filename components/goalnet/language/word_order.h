// How people order and cut up what they say, mended in the words before any grammar: each brings one kind of
// sentence into the order that the grammar reads. All leave other sentences as they are.
#pragma once

#include <string>
#include <vector>

namespace goalnet::inference {

class Language;
using Sentence = std::vector<std::string>;

// false_starts.cc: "turn on the, what's it called, the tv" -> "turn on the tv"; "coke coke coke" -> "coke".
void drop_false_starts(Sentence& words, const Language& language);
void drop_nameless(Sentence& words, const Language& language);
void drop_repetitions(Sentence& words, const Language& language);
void drop_topics_named_again(Sentence& words, const Language& language);
// measures.cc: "about 250 ml of water" -> "water".
void drop_measures(Sentence& words, const Language& language);
// run_on.cc: pauses where speech has none, "ice cream in the fridge it is melting", "in the sink no in the
// fridge"; and asides between pauses that only ask for assent (", isn't it,").
void drop_tags(Sentence& words, const Language& language);
void part_run_ons(Sentence& words, const Language& language);
// retractions.cc: "turn on the stove, never mind that, ..." -> "turn on the stove, correction, ...".
void mark_retractions(Sentence& words, const Language& language);
// cataphora.cc: "put it in the fridge, the mug" -> "put the mug in the fridge".
void name_what_comes_last(Sentence& words, const Language& language);
// "the second armchair, take its pillow" -> "..., take the pillow on the second armchair".
void say_whose_it_is(Sentence& words, const Language& language);
// where_wanted.cc: "the bowl, that's where I want the egg" -> "put the egg to the bowl".
void put_where_wanted(Sentence& words, const Language& language);
// complaints.cc: "somebody didn't shut the door" -> "you forgot to shut the door"; "I can't hear a word they
// say on the tv" -> "raise the volume"; "the beer is on the shelf, so, please?" -> "wish the beer on the
// shelf".
void say_what_was_left_undone(Sentence& words, const Language& language);
void mend_what_annoys(Sentence& words, const Language& language);
void say_what_is_not_heard(Sentence& words, const Language& language);
void turn_on_what_is_to_be_seen(Sentence& words, const Language& language);
void wish_what_is_far(Sentence& words, const Language& language);
// After rewriting: "there is no fork on my plate, do_that" -> "put fork on my plate".
void supply_what_lacks(Sentence& words, const Language& language);
// object_first.cc: "in the sink the bowl you must put" -> "put the bowl in the sink"; "the chips I
// would like" -> "i would like the chips"; "the tap please to turn on" -> "turn on the tap".
void verbs_first(Sentence& words, const Language& language);
void places_last(Sentence& words, const Language& language);
void wished_things_last(Sentence& words, const Language& language);
// statement_order.cc: "is too loud the tv" -> "the tv is too loud"; "is the tv on? it shouldn't be" -> "the
// tv should not be on".
void subjects_first(Sentence& words, const Language& language);
void answer_what_should_be(Sentence& words, const Language& language);
// "all she drinks is coke" -> "she drinks coke"; "the coffee has to go down the drain" -> "empty the coffee".
void uncleave(Sentence& words, const Language& language);
void let_it_go(Sentence& words, const Language& language);
// contrasts.cc: "not the books on the shelf, leave those, but the one on the couch" -> "wish the book on
// ...".
void want_what_it_is(Sentence& words, const Language& language);
void keep_the_contrast(Sentence& words, const Language& language);
// said_after.cc: "the burner, number three" -> "the burner three"; "the discs both of them" -> "both the
// discs ,"; "the armchair, it is the one without a pillow" -> "the armchair without a pillow"; "Book. Any
// book." -> "wish any book".
void numbers_said_after(Sentence& words, const Language& language);
void counts_said_after(Sentence& words, const Language& language);
void things_said_after(Sentence& words, const Language& language);
void places_said_after(Sentence& words, const Language& language);
void descriptions_said_after(Sentence& words, const Language& language);
void ask_for_any(Sentence& words, const Language& language);
// lead_ins.cc: "you know what would be nice, a coke" -> "wish a coke"; "had a terrible night. ..."; "friends
// come at eight"; "can you hear me ok so ...".
void drop_lead_ins(Sentence& words, const Language& language);
// steps.cc: "kettle, fill with water, then onto burner one" -> "fill kettle with water, then put it onto
// burner one"; "coke, glass, pour it" -> "pour coke into glass"; "..., so fridge" -> "so put it to fridge".
void spell_out_steps(Sentence& words, const Language& language);
void join_thing_and_place(Sentence& words, const Language& language);
void short_places(Sentence& words, const Language& language);
void put_it_there(Sentence& words, const Language& language);

}  // namespace goalnet::inference
