// A DDS domain of its own for every test program, so that tests can run at the same time.
#pragma once

#include <unistd.h>

namespace goalnet::ros {

// Differs between users' parallel runs of the suite as well.
inline int test_domain(int base) { return base + static_cast<int>(getpid() % 4) * 12; }

inline const int kPubSubDomain = test_domain(120);
inline const int kNodeDomain = test_domain(121);
inline const int kServiceDomain = test_domain(122);
inline const int kActionDomain = test_domain(123);
inline const int kLifecycleDomain = test_domain(124);
inline const int kGraphDomain = test_domain(125);
inline const int kBagDomain = test_domain(126);

}  // namespace goalnet::ros
