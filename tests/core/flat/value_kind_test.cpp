#include "tests/core/flat/flat_support.hpp"

/// A value that is no scalar and no array of scalars, wherever one of those is wanted.
namespace analogon {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// The model M with `what` in the place of every V, and of every W where it has two elements.
std::vector<std::string> faultsWith(std::string text, const std::string& what, const std::string& several) {
    for (const auto& [letter, name] : {std::pair('V', what), std::pair('W', several)})
        for (std::size_t at = text.find(letter); at != std::string::npos; at = text.find(letter, at + name.size()))
            text.replace(at, 1, name);
    return faultsOf(
        "package P record Pair Real a; Real b; end Pair; function twice input Real u; output Real y; algorithm y := "
        "2*u; end twice; class Box extends ExternalObject; function constructor input Real u; output Box box; external "
        "\"C\" box = makeBox(u); end constructor; function destructor input Box box; external \"C\" freeBox(box); end "
        "destructor; end Box; function opened input Real u[:]; output Real y; algorithm y := sum(u); end opened; end "
        "P; model M parameter P.Pair c = P.Pair(1, 2), cs[2] = {P.Pair(1, 2), P.Pair(3, 4)}; parameter P.Box box = "
        "P.Box(1); " +
        text + " end M;");
}

constexpr const char* places[] = {
    "Real x = V;",
    "Real x[2] = W;",
    "Real x[2](each start = V); equation der(x) = {1, 1};",
    "Real x[2](start = W); equation der(x) = {1, 1};",
    "Real x(start = V); equation der(x) = 1;",
    "Real x(min = V) = 1;",
    "Real x(fixed = V, start = 1); equation der(x) = 1;",
    "Real x(unit = V) = 1;",
    "Real x(stateSelect = V) = 1;",
    "parameter Real p = V; Real x = p;",
    "parameter Real p[2] = W; Real x = p[1];",
    "parameter Integer n = V; Real x = n;",
    "parameter Integer n = V; Real x[n] = ones(n);",
    "parameter Boolean b = V; Real x = if b then 1 else 2;",
    "parameter String s = V; Real x = 1; equation assert(x > 0, s);",
    "type E = enumeration(one, two); parameter E e = V; Real x = if e == E.one then 1 else 2;",
    "Real x; equation x = V;",
    "Real x; equation V = x;",
    "Real x[2]; equation x = W;",
    "Real x; equation 2*x = V;",
    "Real x; equation der(x) = V;",
    "Real x = V + 1;",
    "Real x = -V;",
    "Real x = 2*V;",
    "Real x[2] = 2*W;",
    "Real x = V^2;",
    "Real x = sin(V);",
    "Real x = max(V, 1);",
    "Real x = max(W);",
    "Real x = sum(W);",
    "Real x = noEvent(V);",
    "Real x = smooth(0, V);",
    "Real x = homotopy(V, 1);",
    "Real x = delay(V, 1);",
    "Real x = abs(V);",
    "Real x[2] = fill(V, 2);",
    "Real x[2] = fill(1, V);",
    "Real y[2] = {V, 1}, x = y[1];",
    "Real x[2] = cat(1, W, W);",
    "Real x = [V, 1; 2, 3]*{1, 2}*{1, 2};",
    "Real x = transpose(W)*{1};",
    "Real x[2] = vector(W);",
    "Real x = scalar(W);",
    "Real x = integer(V);",
    "Real x = Integer(V);",
    "Real y[2] = {1, 2}, x = y[V];",
    "Real x = if V then 1 else 2;",
    "Real x = if time > 1 then V else 1;",
    "Real x = if V > 1 then 1 else 2;",
    "Real x = if V == 1 then 1 else 2;",
    "Boolean b = not V; Real x = 1;",
    "Boolean b = V and true; Real x = 1;",
    "Boolean b = time > 1; Real x = if pre(V) then 1 else 2;",
    "Real x = P.twice(V);",
    "Real x = P.opened(W);",
    "Real x[2] = P.twice(W);",
    "Real x = semiLinear(V, 1, 2);",
    "Real x; equation for i in V loop x = i; end for;",
    "Real x; equation for i in 1:V loop x = i; end for;",
    "Real x; equation if V then x = 1; else x = 2; end if;",
    "Real x = 1; equation assert(V, \"no\");",
    "Real x = 1; equation assert(x > 0, V);",
    "Real x = 1; equation when V then terminate(\"end\"); end when;",
    "Real x = 1; equation when x > 2 then terminate(V); end when;",
    "Real x(start = 0); equation der(x) = 1; when x > 2 then reinit(x, V); end when;",
    "Real x = 1; discrete Real y; equation when x > 2 then y = V; end when;",
    "Real x = if sample(V, 1) then 1 else 2;",
    "Real x; initial equation x = V; equation der(x) = 1;",
    "Real x; algorithm x := V;",
    "Real x[2]; algorithm x := W;",
    "Real x[2]; algorithm x[1] := V; x[2] := V;",
    "Real x; algorithm if V then x := 1; else x := 2; end if;",
    "Real x; algorithm x := 0; while V loop x := 1; end while;",
    "Real x; algorithm x := 0; for i in V loop x := i; end for;",
    "model N parameter Real q; Real y = q; end N; N n(q = V);",
    "model N parameter Real q; Real y = q; end N; N n[2](q = W);",
    "model N parameter Real q; Real y = q; end N; N n[2](each q = V);",
    "Real x = String(V);",
    "Real x = 1; Real y if V; ",
    "Real x[V] = {1, 2};",
};

TEST(ValueKind, ARecordIsNoNumber) {
    for (const std::string place : places) EXPECT_THAT(faultsWith(place, "c", "cs"), Not(IsEmpty())) << place;
    EXPECT_THAT(faultsWith("Real x = V;", "c", ""), Contains(HasSubstr("'x' is Real and cannot be P.Pair")));
    EXPECT_THAT(faultsWith("Real x[2] = W;", "", "cs"), Contains(HasSubstr("'x' is Real and cannot be P.Pair[2]")));
}

TEST(ValueKind, AnExternalObjectIsNoNumber) {
    for (const std::string place : places) EXPECT_THAT(faultsWith(place, "box", "box"), Not(IsEmpty())) << place;
}

TEST(ValueKind, AFunctionIsNoNumber) {
    for (const std::string place : places)
        EXPECT_THAT(faultsWith(place, "P.twice", "P.twice"), Not(IsEmpty())) << place;
    for (const std::string place : places) {
        if (place.find("(V") == std::string::npos) continue;  // such a value is an argument
        EXPECT_THAT(faultsWith(place, "function P.twice()", ""), Not(IsEmpty())) << place;
    }
}

}  // namespace
}  // namespace analogon
