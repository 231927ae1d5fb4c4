#include "core/base/distinct.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>

namespace analogon {

namespace {

using Key = std::tuple<std::string, std::string, int, int>;

/// A fault and a warning in the same words are one message: the severity is no part of it.
Key keyOf(const Diagnostic& d) { return {d.message.english(), d.place.file, d.place.line, d.place.column}; }

bool isFault(const Diagnostic& d) { return d.severity == Severity::Error; }

}  // namespace

bool isSame(const Diagnostic& a, const Diagnostic& b) { return keyOf(a) == keyOf(b); }

Diagnostics notYetTold(Diagnostics diagnostics, const Diagnostics& told) {
    std::stable_partition(diagnostics.begin(), diagnostics.end(), isFault);
    std::set<Key> known;
    for (const Diagnostic& d : told) known.insert(keyOf(d));
    Diagnostics fresh;
    std::copy_if(std::make_move_iterator(diagnostics.begin()), std::make_move_iterator(diagnostics.end()),
                 std::back_inserter(fresh), [&](const Diagnostic& d) { return known.insert(keyOf(d)).second; });
    return fresh;
}

Diagnostics distinct(Diagnostics diagnostics) { return notYetTold(std::move(diagnostics), {}); }

}  // namespace analogon
