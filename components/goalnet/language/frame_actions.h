// Clauses to actions, one frame at a time: what each verb asks for.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "components/goalnet/language/frame_context.h"

namespace goalnet::inference {

class FrameActions : public FrameContext {
 public:
  using FrameContext::FrameContext;

  // Adds what the clause asks for; otherwise adds nothing and says why not, in one sentence.
  std::string add(const Clause& clause);
  // "pass me the coke? It should be in the fridge": makes a statement of each command that only tells where a
  // thing that was asked for before is thought to be. Before the first add().
  void believe_places(std::vector<Clause>& clauses);
  // Takes note of what a statement or question is about: "it" means that from here on.
  void notice(const Clause& clause);
  // What a forbidden clause would do must not be among the actions; says which is.
  std::string check_forbidden(const Clause& clause, const SymState& start) const;
  // Why what a statement tells cannot be so ("a burner is on" where none is); empty: it can.
  std::string contradicted(const Clause& statement);

 private:
  // Tries one way of reading a clause; nothing where it is not that.
  using Attempt = std::optional<Problem>;
  using Reading = Attempt (FrameActions::*)(const Clause&);

  // frame_actions.cc: what is done
  Problem dispatch(const Clause& clause);
  Attempt first_that_fits(std::span<const Reading> readings, const Clause& clause);
  Problem change_channel(const NounPhrase& channel);
  Problem raise(const Clause& clause);
  Problem try_to_go(const Clause& clause);
  Clause what_holds_it(const Clause& said);

  // frame_conditions.cc
  bool holds(const Clause& statement, Problem& problem);
  bool shows_channel(int number) const;
  bool anything_is_where_said(const NounPhrase& subject);
  Symbol object_judged(const Clause& statement, const NounPhrase& plain, const Objects& objects);
  bool is_as_said(const NounPhrase& phrase);
  // Whether it is on, open, full, ... now; nothing for states that no fact tells.
  std::optional<bool> is_so(Symbol object, const std::string& state) const;
  // Whether the clause is to be done, by its condition.
  bool wanted(const Clause& clause, Problem& problem);

  // frame_take.cc, frame_take_wished.cc, frame_give.cc, frame_tray.cc: going to things, having them
  Problem go(const Clause& clause);
  Problem take(const Clause& clause);
  Attempt take_on_tray(const Clause& clause);
  Attempt take_scoop_or_channel(const Clause& clause);
  Attempt place_each_wished(const Clause& clause);
  Attempt clear_what_is_on_it(const Clause& clause);
  Attempt place_where_located(const Clause& clause);
  Attempt clear_wished_place(const Clause& clause);
  Attempt gather_at_place(const Clause& clause);
  Attempt give_content(const Clause& clause);
  Attempt give(const Clause& clause);
  Attempt give_to_place(const Clause& clause);
  Attempt give_topping(const Clause& clause);
  Attempt give_time_in_heat(const Clause& clause);
  Attempt fill_what_is_held(const Clause& clause);
  Attempt place_wished_it(const Clause& clause);
  Attempt add_wished_topping(const Clause& clause);
  Attempt make_wished_drink(const Clause& clause);
  Attempt make_in_each(const Clause& clause, const NounPhrase& thing);
  Attempt take_to_place(const Clause& clause);
  Attempt turn_on_wished_device(const Clause& clause);
  Problem take_in_hand(const Clause& clause);
  Problem take_up(Symbol object);
  Problem put_wanted(Clause clause);
  Problem put_on_tray(const Clause& clause);

  // frame_put.cc, frame_put_roles.cc, frame_put_at.cc: putting things somewhere
  Problem put(const Clause& clause);
  Attempt fetch_the_one_there(const Clause& clause);
  void move_what_is_joined(Clause& clause);
  void part_thing_from_place(Clause& clause);
  void load_place_with_thing(Clause& clause);
  Attempt put_in_what_is_named(Clause& clause);
  void put_what_is_unsaid(Clause& clause);
  const NounPhrase* destination_of(Clause& clause);
  const NounPhrase* beside_what_is_with_it(Clause& clause);
  Problem put_there(Clause& clause, const NounPhrase& destination);
  Attempt pour_what_is_in(const Clause& clause, const NounPhrase& thing, const Objects& into);
  Attempt squeeze_on_ice_cream(const Clause& clause, const NounPhrase& thing, const Objects& into);
  void bag_for_the_bin(Clause& clause, const NounPhrase& thing, const Objects& into) const;
  Problem fill_what_is_put(const Clause& clause);
  static void count_for_each_place(Clause& clause, const NounPhrase& thing, const NounPhrase& destination,
                                   std::size_t places);
  Problem put_things(const Clause& clause, const NounPhrase& thing, const NounPhrase& destination,
                     const Objects& places);
  Attempt put_on_each(const Clause& clause);
  Attempt put_content(const Clause& clause, const NounPhrase& thing, const NounPhrase& destination,
                      const Objects& vessels);
  Problem put_with(const NounPhrase& with, Symbol object, Where where);
  Problem put_at(const Clause& clause, const Objects& objects, const NounPhrase& destination);
  Problem put_one(Symbol object, Symbol target, Where where);
  Objects beside(const NounPhrase& destination, const Objects& objects, Where& where, Problem& problem);

  // frame_put_unplaced.cc, frame_put_away.cc, frame_insert.cc: putting where no place is said
  Problem put_without_place(const Clause& clause);
  Attempt put_out(const Clause& clause);
  Attempt put_device_on(const Clause& clause);
  Attempt put_kettle_on(const Clause& clause);
  Attempt put_under_tap(const Clause& clause);
  Attempt put_disc_in(const Clause& clause);
  Attempt put_into_last(const Clause& clause);
  Attempt keep_as_it_is(const Clause& clause);
  Attempt fling(const Clause& clause);
  Attempt shelve(const Clause& clause);
  Attempt tidy_place(const Clause& clause);
  Attempt leave_as_it_is(const Clause& clause);
  Attempt put_down(const Clause& clause);
  Attempt bring_to_person(const Clause& clause);
  Attempt put_some_on_last(const Clause& clause);
  bool names_burner(const NounPhrase& phrase) const;
  Problem put_away(const Clause& clause);
  static bool says_away(const Clause& clause);
  Problem put_by_its_kind(const Clause& clause, const Objects& objects);
  void what_was_moved(const Clause& clause, Objects& objects) const;
  Problem stack(const Objects& objects);
  Problem insert(const Clause& clause);

  // frame_discard.cc, frame_tidy.cc, frame_release.cc: throwing away, clearing, swapping, cooling, playing
  Problem discard(const Clause& clause);
  Attempt discard_content(const Clause& clause);
  Attempt throw_to_place(const Clause& clause);
  Attempt throw_in_named_bin(const Clause& clause);
  Attempt throw_to_person(const Clause& clause);
  Attempt throw_in(const Clause& clause);
  Attempt throw_nowhere(const Clause& clause);
  Attempt discard_what_is_told(const Clause& clause);
  Problem release(const Clause& clause);
  Problem swap(const Clause& clause);
  Objects things_to_swap(const Clause& clause, Problem& problem);
  void add_one_at(const NounPhrase& things, const NounPhrase& place, Objects& found);
  Problem clear(const Clause& clause);
  Objects things_to_clear(const Clause& clause, const Objects& places, bool things_named);
  Symbol place_for_cleared(const Objects& places) const;
  Problem cool(const Clause& clause);
  Problem play(const Clause& clause);

  // frame_water.cc, frame_pour.cc, frame_wash.cc: water and drinks
  Problem fill(const Clause& clause);
  void fill_it_into_place(Clause& clause, Symbol& content) const;
  void want_what_is_named_in(Clause& clause, Symbol& content) const;
  Problem fill_with(const NounPhrase& with, const Objects& vessels, Symbol content);
  Problem fill_one(Symbol vessel, Symbol content);
  Problem fill_with_water(Symbol vessel);
  bool is_sprinkled(Symbol content) const;
  Symbol content_of(Symbol vessel) const;
  Problem pour(const Clause& clause);
  Attempt pour_from_first_place(const Clause& clause);
  Attempt pour_a_cup(const Clause& clause);
  Attempt pour_whatever_is_in(const Clause& clause);
  Attempt pour_what_is_no_drink(const Clause& clause);
  Objects pour_targets(const Clause& clause, Problem& problem);
  bool pour_over(const Clause& clause, Objects& targets) const;
  Symbol pour_source(const Clause& clause, Symbol content, const Objects& targets, Problem& problem);
  Symbol named_source(const NounPhrase& from, Symbol content, const Objects& targets, Problem& problem);
  Problem pour_out(const Clause& clause, Symbol content, Symbol source, Objects targets);
  Problem pour_into(Symbol source, Symbol vessel, bool named);
  Problem empty(const Clause& clause);
  Attempt empty_into_vessel(const Clause& clause);
  Attempt unload_there(const Clause& clause);
  Attempt dump_there(const Clause& clause);
  Attempt dump_empty_there(const Clause& clause);
  Attempt empty_place(const Clause& clause);
  Attempt dump_away(const Clause& clause);
  Problem wash(const Clause& clause);

  // frame_heat.cc, frame_food.cc, frame_scoop.cc, frame_make.cc: heat and food
  Problem heat(const Clause& clause, bool boil);
  void read_where_to_heat(const Clause& clause, bool& microwave, bool& stove, const NounPhrase*& where);
  Attempt cook_a_dish(const Clause& clause);
  Objects objects_to_heat(const Clause& clause, Problem& problem);
  Symbol vessel_to_heat_water_in(const Clause& clause, bool named_vessel);
  Symbol pot() const;  // kNone: there is none
  Problem boil_in_water(const Clause& clause, const Objects& objects, const NounPhrase* where);
  Problem heat_objects(const Objects& objects, bool microwave, const NounPhrase* where);
  Problem add_to(const Clause& clause);
  void add_what_is_joined(Clause& clause);
  bool seasons(const Clause& clause, const NounPhrase& dish);
  Objects add_targets(const Clause& clause, const NounPhrase* destination,
                      const std::vector<NounPhrase>& whats, Problem& problem);
  Problem add_one(const Clause& clause, const NounPhrase& what, Symbol target, const Objects& targets,
                  const Objects& sources);
  Problem add_it(const NounPhrase& what, Symbol target, const Objects& targets);
  Problem cannot_be_squeezed(const Clause& clause, const NounPhrase& what);
  Problem add_content(const NounPhrase& what, Symbol target, bool& done);
  Problem scoop(const Clause& clause);
  Problem scoop_into(Symbol target, int times);
  bool can_be_scooped(const NounPhrase& thing) const;
  Problem squeeze_on_scoops(const Clause& clause, const Objects& targets);
  Problem make(const Clause& clause);
  Attempt serve_food(const Clause& clause, const NounPhrase& thing, Symbol content);
  Problem cook_noodles_in_their_cup(const NounPhrase& thing);
  Symbol vessel_to_make_it_in(const Clause& clause, const NounPhrase& thing, Symbol content,
                              Problem& problem);
  Problem make_water(const Clause& clause, const NounPhrase& thing, Symbol vessel);
  Problem make_coffee(const NounPhrase& thing, Symbol vessel);
  Problem make_canned_drink(const Clause& clause, Symbol content, Symbol vessel);
  Problem boil_food(const NounPhrase& thing, Symbol food, Symbol vessel);
  bool heats_in_microwave(Symbol vessel) const;

  // frame_turn.cc, frame_devices.cc, frame_doors.cc, frame_television.cc: knobs, doors and the television
  Problem turn(const Clause& clause, int on);
  int on_or_off(const Clause& clause, int on);
  bool names_knob(const NounPhrase& phrase);
  Attempt turn_what_moves(const Clause& clause, int on);
  Attempt turn_named(const Clause& clause, const NounPhrase& said, int on, bool& any);
  Attempt turn_what_is_used(const Clause& clause, const NounPhrase& phrase, int on, Objects& devices);
  void leave_out_excepted(const Clause& clause, Objects& devices);
  Problem turn_devices(const Clause& clause, const Objects& devices, int on, const NounPhrase& phrase);
  Objects pronoun_device(const NounPhrase& phrase, int on) const;
  Objects named_devices(const NounPhrase& phrase, int on);
  Objects burners_that_are_meant(const NounPhrase& phrase, const Objects& burners, int on);
  Objects devices_to_turn_off() const;
  Objects other_devices_on() const;
  Objects only_device_left(int on) const;
  Problem turn_on(Symbol device, bool on, int number);
  Problem toggle_to(bool on, Symbol object, Symbol value, const SymAction& toggle);
  Problem turn_knob(int number, bool on);
  int knob_that_is_meant() const;
  bool is_on(Symbol device) const;
  static bool is_switched(Symbol thing);  // the television, the stove or a burner
  bool only_devices(const Clause& clause) const;
  Problem door(const Clause& clause, bool open);
  Problem close_all();
  Attempt open_or_close_named(const NounPhrase& phrase, bool open, bool left, bool right);
  Objects pronoun_door(const NounPhrase& phrase) const;
  Objects door_that_is_meant(Objects things, bool open, bool one_side) const;
  Problem open_or_close(Symbol thing, bool open, bool left, bool right);
  static bool is_openable(Symbol thing);
  bool is_open(Symbol thing) const;
  Problem television(const Clause& clause);
  Problem press_to_channel(const Clause& clause, bool down);
  bool is_not_of_television(const NounPhrase& phrase) const;
  bool about_television(const Clause& clause) const;
  const NounPhrase* channel_of_television(const Clause& clause) const;
};

}  // namespace goalnet::inference
