// Channels and volume.
#include <algorithm>
#include <array>

#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

namespace {

constexpr int kChannels = 6;

}  // namespace

bool FrameActions::about_television(const Clause& clause) const {
  if (clause.frame == Frame::kMute && clause.phrases.empty()) return true;  // "mute please"
  for (const NounPhrase& phrase : clause.phrases) {
    if (language_.tv_word(phrase.phrase)) return true;
    for (const Symbol named : phrase.phrase.empty() ? Objects{} : resolver_.named(phrase))
      if (named == kTv_1) return true;
    if (phrase.pronoun) {
      const auto it = pronoun(phrase, Sort::kDevice, {});
      if (!it.empty() && it.front() == kTv_1) return true;
      const bool sound =
          clause.frame == Frame::kRaise || clause.frame == Frame::kLower || clause.frame == Frame::kMute;
      if (it.empty() && sound && history_.empty()) return true;  // "make it quiet"
    }
  }
  return clause.has("channel") || clause.has("volume") || clause.has("sound");
}

// "I want the tv on channel 4": the channel, where the clause names the television as well and nothing else
// ("turn the pillow to channel 4") but what is shown there ("the game on channel 4").
const NounPhrase* FrameActions::channel_of_television(const Clause& clause) const {
  static constexpr std::array kOthers = {Frame::kStop, Frame::kChange, Frame::kMute, Frame::kRaise,
                                         Frame::kLower};
  if (std::find(kOthers.begin(), kOthers.end(), clause.frame) != kOthers.end() || clause.has_particle("off"))
    return nullptr;
  const NounPhrase* channel = nullptr;
  bool television = false;
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.phrase == "channel" && phrase.number > 0) channel = &phrase;
    const auto named = phrase.phrase.empty() ? Objects{} : resolver_.named(phrase);
    const bool names_it = std::find(named.begin(), named.end(), Symbol{kTv_1}) != named.end();
    if (!named.empty() && !names_it && phrase.role == Role::kDirect &&
        !resolver_.is_of_class(named.front(), "cd"))
      return nullptr;
    television = television || names_it;
    for (const NounPhrase& place : phrase.at)
      if (place.phrase == "channel" && place.number > 0) channel = &place;
  }
  return television ? channel : nullptr;
}

std::string FrameActions::television(const Clause& clause) {
  if (!resolver_.exists(kTv_1)) return not_here("there is no television here");
  const bool by_state = language_.wanted_by_state(clause.verb) != Frame::kNone;  // "make the book louder"
  const bool other_things = std::ranges::any_of(
      clause.phrases, [&](const NounPhrase& phrase) { return is_not_of_television(phrase); });
  if (!about_television(clause) || other_things)  // "mute the pillow"
    return "it is not clear what to " + (by_state ? "make " + clause.verb : clause.verb);
  const bool down = clause.has("down") || clause.has("previous") || clause.has("lower") ||
                    clause.has("back") || clause.has("last") || clause.has("before") ||
                    clause.frame == Frame::kLower;
  const bool channels = clause.has("channel") || clause.frame == Frame::kChange;
  const bool quiet = down || clause.frame == Frame::kMute || clause.has_particle("off");
  if (!channels && quiet && !is_on(kTv_1)) {  // it is silent already
    remember({Symbol{kTv_1}});
    silent_ = clause.frame == Frame::kMute;  // "tv please, no sound, channel two"
    return {};
  }
  if (const Problem problem = turn_on(kTv_1, true, 0); !problem.empty()) return problem;
  remember({Symbol{kTv_1}});
  if (channels) return press_to_channel(clause, down);
  if (now_.is(kTv_1, kVolume) != quiet) return {};
  return act({Verb::kPress, quiet ? Symbol{kTv_1VolumeDownButton} : Symbol{kTv_1VolumeUpButton}});
}

bool FrameActions::is_not_of_television(const NounPhrase& phrase) const {
  if ((at_home_ && phrase.role == Role::kExcept) || phrase.phrase.empty() || language_.tv_word(phrase.phrase))
    return false;
  const auto named = resolver_.named(phrase);
  return !contains(named, kTv_1) && !contains(named, kTv_1Remote_1);
}

// "channel 5", "two channels down", "any channel except three"
std::string FrameActions::press_to_channel(const Clause& clause, bool down) {
  int channel = 0, steps = 1, avoided = 0;
  for (const NounPhrase& phrase : clause.phrases) {
    if (at_home_ && phrase.role == Role::kExcept) {
      avoided = phrase.number;
      continue;
    }
    if (phrase.phrase == "channel" && phrase.count > 0 && phrase.number == 0) steps = phrase.count;
    channel = std::max({channel, phrase.number, phrase.ordinal, phrase.pronoun ? phrase.count : 0});
  }
  int now = 0;
  for (int i = 1; i <= kChannels; ++i)
    if (now_.is(kTv_1, static_cast<Symbol>(kChannel1 + i - 1))) now = i;
  if (now == 0) return "it is not known which channel is on";
  if (channel > kChannels) {
    no_such_number_ = true;
    return "there is no channel " + std::to_string(channel) + "; there are channels 1 to " +
           std::to_string(kChannels);
  }
  if (avoided > 0 && channel == 0 && now != avoided) return {};
  const int by = (steps % kChannels) * (down ? kChannels - 1 : 1);
  const int target = channel > 0 ? channel : (now - 1 + by) % kChannels + 1;
  const bool up = (target - now + kChannels) % kChannels <= kChannels / 2;
  for (; now != target; now = (now - 1 + (up ? 1 : kChannels - 1)) % kChannels + 1)
    if (const Problem problem =
            act({Verb::kPress, up ? Symbol{kTv_1ChannelUpButton} : Symbol{kTv_1ChannelDownButton}});
        !problem.empty())
      return problem;
  if (at_home_ && (silent_ || clause.frame == Frame::kMute) && now_.is(kTv_1, kVolume))
    return act({Verb::kPress, Symbol{kTv_1VolumeDownButton}});
  return {};
}

}  // namespace goalnet::inference
