#pragma once

#include <cstdint>
#include <string_view>

namespace analogon {

inline constexpr std::uint64_t fnvOffset = 14695981039346656037ull;

/// FNV-1a of a text, going on from `hash` (Fowler, Noll and Vo): the same on every machine and in every run, which
/// std::hash need not be. No protection against intent.
constexpr std::uint64_t fnv1a(std::string_view text, std::uint64_t hash = fnvOffset) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
    return hash;
}

}  // namespace analogon
