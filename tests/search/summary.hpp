#pragma once

#include <map>
#include <string>
#include <vector>

/// What a search came to, as lines that two versions of the program can be compared by.
namespace analogon::net {

/// Each line by its name: "effects/friction.coulomb at rotor.flange_a/parameters/tau_c/value" -> "0.0712".
using Summary = std::map<std::string, std::string>;

/// Of report.json and of what `discover --trace` has written, less times and the version of the program. Numbers have
/// six significant digits; "exact" is a hash of every digit of the report.
Summary summaryOf(const std::string& report, const std::string& trace);

/// The same for a repository: candidates and the steps of the trace that are made by the hundred (screenings, trials,
/// judgements) as their number and a hash.
Summary condensed(const Summary& summary);

struct Difference {
    std::string name, before, after;  // "-": there is none
};
/// Line by line. Where one of two is condensed, so is the other.
std::vector<Difference> differences(const Summary& before, const Summary& after);

/// One line each, "name<tab>value".
std::string textOf(const Summary& summary);
Summary summaryFrom(const std::string& text);

}  // namespace analogon::net
