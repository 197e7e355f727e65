// Fast DDS 2.9 ends the process (an assertion) where a participant elsewhere leaves just when the timer that
// watches its lease fires: the timer's thread waits for the lock while the data of that participant is
// cleared, and then asserts that it is not (docs/design/076). The function that does so is replaced by ours:
// the program's definition stands before that of the library.
#pragma once

namespace goalnet::ros::detail {

// Whether Fast DDS calls our function; false where this library is loaded after Fast DDS, as a plug-in would
// be. Always true with Fast DDS 2.10 and later, which needs none. A program that calls this has ours in it.
bool lease_checks_are_ours();

}  // namespace goalnet::ros::detail
