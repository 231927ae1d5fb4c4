#include "core/flat/external_functions.hpp"

#include "tests/core/flat/flat_support.hpp"

namespace analogon {
namespace {

using namespace test;
using ::testing::HasSubstr;

TEST(ExternalFunctions, WhatAModelPrintsIsToldAndNoFileIsWritten) {
    const std::string print =
        "function print input String s = \"\"; input String file = \"\"; "
        "external \"C\" ModelicaInternal_print(s, file); end print; "
        "function f input Real x; output Real y; algorithm ";
    const auto library = Library().withSource(std::make_shared<const Source>(
        "m.mo", print + "print(\"a gain of \" + String(2)); print(\"x\", \"no/such/place\"); y := 2*x; end f; model M "
                        "Real x = f(time); end M;"));
    ASSERT_TRUE(library) << format(library.diagnostics());
    const Outcome<FlatModel> flat = flatten(*library, "M");
    ASSERT_TRUE(flat) << format(flat.diagnostics());
    EXPECT_THAT(format(flat.diagnostics()), HasSubstr("the model prints: a gain of 2"));
    EXPECT_THAT(format(flat.diagnostics()), HasSubstr("the model prints to 'no/such/place', which is not written: x"));
}

}  // namespace
}  // namespace analogon
