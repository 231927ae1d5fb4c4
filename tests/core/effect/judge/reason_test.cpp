#include "core/effect/judge/reason.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace analogon {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

Acceptance passed() {
    Acceptance a;
    a.evidence = 200;
    a.effective = 150;
    a.asked.evidence = 30;
    a.heldOut = 0.9;
    a.share = 2;
    a.isSignificant = a.holdsOut = a.isWorthwhile = true;
    return a;
}

TEST(WhyRefused, NamesTheTestThatFailsAndItsFigures) {
    EXPECT_THAT(whyRefused(passed(), 0.5).english(), IsEmpty());
    Acceptance byChance = passed();
    byChance.isSignificant = false;
    byChance.evidence = 12;
    byChance.effective = 15;
    EXPECT_THAT(whyRefused(byChance, 0.5).english(), HasSubstr("chance may: evidence 15, and 30 is asked for"));
    Acceptance atEdges = byChance;
    atEdges.isAtEdges = true;
    EXPECT_THAT(whyRefused(atEdges, 0.5).english(), HasSubstr("right behind changes of an input"));
    Acceptance contradicted = passed();
    contradicted.heldOut = 0.3;
    EXPECT_THAT(whyRefused(contradicted, 0.5).english(),
                HasSubstr("bear out 30 % of what it explains, and more than 50 %"));
    EXPECT_THAT(whyRefused(contradicted, 0).english(), IsEmpty()) << "as much is enough there";
    Acceptance detail = passed();
    detail.isWorthwhile = false;
    detail.share = 0.02;
    EXPECT_THAT(whyRefused(detail, 0.5).english(), HasSubstr("2 % of what stays unexplained"));
}

Screened screened(double explained, double visible, bool wrongSign = false) {
    Screened s;
    Probe probe;
    probe.plain.explained = probe.whitened.explained = explained;
    probe.plain.visible = visible;
    probe.plain.wrongSign = wrongSign;
    s.probes = {probe};
    return s;
}

TEST(WhyNotRefitted, SaysWhatTheScreeningShowed) {
    Screened failed;
    failed.failure = "no simulation with this effect succeeded";
    EXPECT_EQ(whyNotRefitted(failed, {}), "could not be tried: no simulation with this effect succeeded");
    Screened absorbed = screened(50, 0);
    absorbed.absorbedBy = {"motor.k", "motor.R"};
    EXPECT_EQ(whyNotRefitted(absorbed, {}), "the data cannot show it: it only shifts motor.k and motor.R");
    EXPECT_THAT(whyNotRefitted(screened(50, 1, true), {}).english(), HasSubstr("wrong physical sign"));
    EXPECT_EQ(whyNotRefitted(screened(0, 1), {}), "explains nothing of what is left");
    EXPECT_THAT(whyNotRefitted(screened(7, 1), {10}).english(), HasSubstr("no more than chance may bring (score 7)"));
    EXPECT_THAT(whyNotRefitted(screened(7, 1), {}).english(), HasSubstr("others promise more"));
}

}  // namespace
}  // namespace analogon
