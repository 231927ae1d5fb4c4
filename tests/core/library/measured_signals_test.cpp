#include "core/library/measured_signals.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace analogon {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Library libraryWith(const MeasuredSignals& signals) {
    const Outcome<Library> library = withMeasured(Library(), signals);
    EXPECT_TRUE(library) << format(library.diagnostics());
    return library ? *library : Library();
}

TEST(MeasuredSignals, AreKeptWithTheirClass) {
    const Library library = libraryWith({"Rigs.Drive", {"rotor.w", "'a \"b\\''.y[2]"}, {"step1.y"}});
    const MeasuredSignals known = measuredOf(library, "Rigs.Drive");
    EXPECT_THAT(known.compared, ElementsAre("rotor.w", "'a \"b\\''.y[2]"));
    EXPECT_THAT(known.driven, ElementsAre("step1.y"));
    EXPECT_THAT(measuredOf(library, "Rigs.Other").compared, IsEmpty());
    EXPECT_THAT(measuredOf(Library(), "Rigs.Drive").driven, IsEmpty());
}

TEST(MeasuredSignals, GoAlongWhenTheModelIsVaried) {
    const Outcome<Library> varied =
        libraryWith({"Drive", {"w"}, {}}).withSource(std::make_shared<const Source>("m.mo", "model Drive end Drive;"));
    ASSERT_TRUE(varied) << format(varied.diagnostics());
    EXPECT_THAT(measuredOf(*varied, "Drive").compared, ElementsAre("w"));
}

TEST(MeasuredSignals, TakeThePlaceOfWhatWasKnownBefore) {
    const Outcome<Library> next = withMeasured(libraryWith({"Drive", {"w"}, {"u"}}), {"Drive", {"phi"}, {}});
    ASSERT_TRUE(next) << format(next.diagnostics());
    EXPECT_THAT(measuredOf(*next, "Drive").compared, ElementsAre("phi"));
    EXPECT_THAT(measuredOf(*next, "Drive").driven, IsEmpty());
}

}  // namespace
}  // namespace analogon
