#include "core/flat/refused_construct.hpp"

#include <algorithm>
#include <array>

namespace analogon {
namespace {

constexpr std::array clocked{"Clock",       "sample",     "previous", "hold",      "subSample", "superSample",
                             "shiftSample", "backSample", "noClock",  "firstTick", "interval"};
constexpr std::array machine{"transition", "initialState", "activeState", "ticksInState", "timeInState"};
constexpr std::array streams{"stream", "inStream", "actualStream"};

template <class Names>
bool isOneOf(const Names& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::optional<RefusedConstruct> refusedConstruct(std::string_view name) {
    if (isOneOf(clocked, name))
        return RefusedConstruct{
            phrase("'{}' belongs to clocked equations (Modelica 3.6, chapter 16), which are not supported", name),
            phrase("sample with 'when sample(start, interval) then' and pre(), or with Modelica.Blocks.Discrete")};
    if (isOneOf(machine, name))
        return RefusedConstruct{
            phrase("'{}' belongs to state machines (Modelica 3.6, chapter 17), which are not supported", name),
            phrase(
                "keep the state in a discrete variable that changes in 'when', or draw it with Modelica.StateGraph")};
    if (isOneOf(streams, name))
        return RefusedConstruct{
            phrase("'{}' belongs to stream connectors (Modelica 3.6, chapter 15), which are not supported", name),
            phrase("use a potential and a flow variable; Modelica.Thermal.FluidHeatFlow models media so")};
    if (name == "spatialDistribution")
        return RefusedConstruct{phrase("the function '{}' is not supported", name),
                                phrase("where the transport takes a constant time T, delay(u, T) does the same")};
    return std::nullopt;
}

bool tellRefused(Messages& messages, std::string_view name, const Span& span) {
    const std::optional<RefusedConstruct> refused = refusedConstruct(name);
    if (refused) messages.refusal(refused->what, span, refused->hint);
    return refused.has_value();
}

}  // namespace analogon
