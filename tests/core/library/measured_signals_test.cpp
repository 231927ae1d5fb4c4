#include "core/library/measured_signals.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/library/library.hpp"

namespace analogon {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(MeasuredSignals, AreKeptWithTheirClass) {
    const Library library = Library().withMeasured({"Rigs.Drive", {"rotor.w", "'a \"b\\''.y[2]"}, {"step1.y"}});
    const MeasuredSignals known = library.measured("Rigs.Drive");
    EXPECT_THAT(known.compared, ElementsAre("rotor.w", "'a \"b\\''.y[2]"));
    EXPECT_THAT(known.driven, ElementsAre("step1.y"));
    EXPECT_THAT(library.measured("Rigs.Other").compared, IsEmpty());
    EXPECT_THAT(Library().measured("Rigs.Drive").driven, IsEmpty());
}

TEST(MeasuredSignals, GoAlongWhenTheModelIsVaried) {
    const Outcome<Library> varied = Library()
                                        .withMeasured({"Drive", {"w"}, {}})
                                        .withSource(std::make_shared<const Source>("m.mo", "model Drive end Drive;"));
    ASSERT_TRUE(varied) << format(varied.diagnostics());
    EXPECT_THAT(varied->measured("Drive").compared, ElementsAre("w"));
}

TEST(MeasuredSignals, TakeThePlaceOfWhatWasKnownBefore) {
    const Library next = Library().withMeasured({"Drive", {"w"}, {"u"}}).withMeasured({"Drive", {"phi"}, {}});
    EXPECT_THAT(next.measured("Drive").compared, ElementsAre("phi"));
    EXPECT_THAT(next.measured("Drive").driven, IsEmpty());
}

}  // namespace
}  // namespace analogon
