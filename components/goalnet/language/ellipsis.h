// What people leave out: "fork. sink." is "fork to sink", "pillows: one on each couch" is "one pillow on each
// couch", "the fork. give." is "give the fork".
#pragma once

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/words.h"

namespace goalnet::inference {

Words fill_ellipses(const Words& words, const Language& language, const Lexicon& lexicon);

}  // namespace goalnet::inference
