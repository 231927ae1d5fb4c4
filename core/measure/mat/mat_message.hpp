#pragma once

#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/measure/mat/mat_channels.hpp"
#include "core/measure/recording.hpp"

/// What a process that reads hands to the one that asked: a length, CBOR (RFC 8949), then values as they lie in memory.
namespace analogon::mat {

std::string encoded(const Outcome<Channels>& channels);
std::string encoded(const Outcome<std::vector<ChannelValues>>& values);

Outcome<Channels> decodedChannels(const std::string& bytes);
Outcome<std::vector<ChannelValues>> decodedValues(const std::string& bytes);

}  // namespace analogon::mat
