// Requests in words that the grammar reads: "put both plates in the sink and turn on the tap".
#pragma once

#include <string>
#include <vector>

#include "components/goalnet/gist/request.h"

namespace goalnet::inference::gist {

std::string in_words(const Views& views, const std::vector<Request>& requests, const Language& language);

}  // namespace goalnet::inference::gist
