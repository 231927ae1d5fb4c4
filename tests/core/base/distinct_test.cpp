#include "core/base/distinct.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

TEST(Distinct, SaysEachMessageOnceAndFaultsFirst) {
    Diagnostic remark = fileError("a gap", "run.csv", 4);
    remark.severity = Severity::Warning;
    const Diagnostic fault = fileError("no column", "study.json", 3, 5);
    const Diagnostic elsewhere = fileError("no column", "study.json", 9, 5);
    const Diagnostics once = distinct({remark, fault, remark, elsewhere, fault});
    ASSERT_EQ(once.size(), 3u);
    EXPECT_TRUE(isSame(once[0], fault));
    EXPECT_TRUE(isSame(once[1], elsewhere)) << "the same words of another place are another message";
    EXPECT_TRUE(isSame(once[2], remark));
}

TEST(Distinct, LeavesOutWhatWasTold) {
    const Diagnostic first = fileError("a", "x"), second = fileError("b", "x");
    const Diagnostics rest = notYetTold({first, second}, {first});
    ASSERT_EQ(rest.size(), 1u);
    EXPECT_TRUE(isSame(rest.front(), second));
    EXPECT_TRUE(notYetTold({second}, {first, second}).empty());
}

}  // namespace
}  // namespace analogon
