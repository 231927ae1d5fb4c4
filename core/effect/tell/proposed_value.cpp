#include "core/effect/tell/proposed_value.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/base/number_text.hpp"
#include "core/base/unit.hpp"
#include "core/effect/model/model_state.hpp"

namespace analogon {
namespace {

/// A parameter of another value, or one that changes, as a proposal at its component.
Remainder changing(const std::string& parameter, double evidence, Text equation) {
    Remainder r;
    r.node = parameter.substr(0, parameter.rfind('.'));
    r.evidence = evidence;
    r.proposal.equation = std::move(equation);
    return r;
}

Text estimateText(const HeldInstead& h) { return Text::number(valueText(h.value, h.standardError)); }

}  // namespace

Remainder remainderOf(const Change& c, double end) {
    Remainder r =
        changing(c.parameter, c.explained,
                 fmt::format("{} = if time < {:.4g} then {:.4g} else {:.4g}", c.parameter, c.time, c.before, c.after));
    r.from = c.time;
    r.to = end;
    return r;
}

double leastOf(const std::vector<CheckOfChange>& checks) {
    const auto all = [](const CheckOfChange&) { return true; };
    return checks.empty() ? -1
                          : meanError(
                                checks, [](const CheckOfChange& c) { return c.least(); }, all);
}

Text remarkOf(const CheckOfChange& c, const std::string& parameter) {
    return phrase(
        "on '{}', which was not fitted, the error is {:.3g} % with the value of {} before that change, {:.3g} % with "
        "the one after it, and {:.3g} % with the change at the same time",
        c.experiment, c.before, parameter, c.after, c.alike);
}

Text remarkOf(const HeldInstead& h, const std::string& effect, const std::string& at) {
    return h.byBound ? phrase(
                           "{} at {} explains no more than {} beyond its bound of {:.5g}: {}{} instead; "
                           "keep the bound only if it is known for certain",
                           effect, at, h.parameter, h.held, estimateText(h), behindNumber(h.unit))
                     : phrase(
                           "{} at {} explains no more than another value of {}, which is held at {:.5g}: {}{} "
                           "instead; hold it only if it is known for certain",
                           effect, at, h.parameter, h.held, estimateText(h), behindNumber(h.unit));
}

Text remarkOf(const HeldInstead& h) {
    return h.byBound ? phrase(
                           "{} beyond its bound of {:.5g} explains more than any effect: {}{} fits; widen "
                           "the bound",
                           h.parameter, h.held, estimateText(h), behindNumber(h.unit))
                     : phrase(
                           "another value of {} explains more than any effect: it is held at {:.5g}, and {}{} "
                           "fits; correct it, or let it be fitted",
                           h.parameter, h.held, estimateText(h), behindNumber(h.unit));
}

Text remarkOfEqual(const HeldInstead& h) {
    return phrase("{} of {}{} instead of {:.5g} explains as much: the data do not tell which is wrong", h.parameter,
                  estimateText(h), behindNumber(h.unit), h.held);
}

Remainder remainderOf(const HeldInstead& h) {
    Remainder r = changing(h.parameter, h.explained, phrase("{} = {:.5g}", h.parameter, h.value));
    r.proposal.errors = h.errors;
    return r;
}

Remainder remainderOf(const ChannelDependence& d) {
    return changing(d.parameter, d.explained,
                    fmt::format("{} = {:.4g} {} {:.4g}*({} - {:.4g})", d.parameter, d.value, d.slope < 0 ? "-" : "+",
                                std::abs(d.slope / d.range), d.channel, d.middle));
}

}  // namespace analogon
