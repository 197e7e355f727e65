// A client that sends captured requests under the very identity that the real one had: Fast DDS lets a
// participant choose its GUID prefix and an endpoint its entity id.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "tests/interoperability/replay/captures.h"

namespace goalnet::ros {

class CapturedClient {
 public:
  // `any_endpoint`: only its prefix counts.
  CapturedClient(int domain, const Gid& any_endpoint);
  ~CapturedClient();
  CapturedClient(const CapturedClient&) = delete;

  // Sends a request from a writer and with a reply reader of the captured identities, made at first use.
  // False if the server was not found within five seconds.
  bool send(const CapturedSample& request);

  struct Reply {
    SampleId related;
    Bytes payload;  // with rmw_cyclonedds's header where there is one
  };
  // Replies that came for that request so far.
  std::vector<Reply> replies_to(const CapturedSample& request) const;

  // Publishes a captured message on its topic.
  bool publish(const CapturedSample& message);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace goalnet::ros
