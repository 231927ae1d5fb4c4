#include "core/effect/catalogue/finding.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

TEST(Finding, NamesAreThoseOfTheReportFormat) {
    std::vector<std::string> names;
    for (const Way w : {Way::Attach, Way::Insert, Way::Specialise, Way::Bridge}) names.emplace_back(name(w));
    EXPECT_EQ(names, (std::vector<std::string>{"attach", "insert", "specialise", "bridge"}));
    names.clear();
    for (const FindingKind k : {FindingKind::Adequate, FindingKind::Effect, FindingKind::Partial,
                                FindingKind::Unexplained, FindingKind::Interrupted})
        names.emplace_back(name(k));
    EXPECT_EQ(names, (std::vector<std::string>{"adequate", "effect", "partial", "unexplained", "interrupted"}));
    names.clear();
    for (const Verdict v : {Verdict::Chosen, Verdict::Equivalent, Verdict::Weaker, Verdict::NotSignificant,
                            Verdict::Absorbed, Verdict::WrongSign, Verdict::FailsHeldOut, Verdict::Failed})
        names.emplace_back(name(v));
    EXPECT_EQ(names, (std::vector<std::string>{"chosen", "equivalent", "weaker", "not significant", "absorbed",
                                               "wrong sign", "fails held-out blocks", "failed"}));
    EXPECT_STREQ(name(Confidence::Established), "established");
    EXPECT_STREQ(name(Confidence::Indicated), "indicated");
}

TEST(Prediction, RemovesAShareOfTheErrorOfWhatWasLeftOut) {
    Prediction p;
    EXPECT_EQ(p.removed(), 0) << "there was no error";
    p.errorPercentBefore = 8;
    p.errorPercentAfter = 6;
    EXPECT_EQ(p.removed(), 0.25);
    p.errorPercentAfter = 10;
    EXPECT_EQ(p.removed(), -0.25) << "it predicts worse";
}

TEST(Correlate, IsWorthAWordOfEitherSign) {
    EXPECT_TRUE((Correlate{"w", 0.15}).isWorthAWord());
    EXPECT_TRUE((Correlate{"w", -0.3}).isWorthAWord());
    EXPECT_FALSE((Correlate{"w", 0.14}).isWorthAWord());
}

TEST(Remainder, WorsensWhatWasNotFittedByMoreThanChance) {
    Remainder r;
    r.proposal.errors.validate = 5;
    EXPECT_FALSE(r.proposal.worsensValidation()) << "nothing is known without it";
    r.proposal.errorValidateWithout = 4;
    EXPECT_TRUE(r.proposal.worsensValidation());
    r.proposal.errorValidateWithout = 4.95;
    EXPECT_FALSE(r.proposal.worsensValidation());
}

TEST(WithValues, TellsTheValuesThatTheEquationNamesAndNoOthers) {
    const std::vector<EffectValue> values{{"y_max", 4.2, 0.1, "V"}, {"y", 3, 0.1, ""}, {"max", 9, 0.1, ""}};
    EXPECT_EQ(withValues("z = min(u, y_max)", values), "z = min(u, y_max) with y_max = 4.2 V");
    EXPECT_EQ(withValues("y = min(u, y_max)", values), "y = min(u, y_max) with y_max = 4.2 V, y = 3");
    EXPECT_EQ(withValues("z = u", values), "z = u");
    EXPECT_EQ(withValues("z = a.y + y_2", values), "z = a.y + y_2") << "parts of other names";
}

}  // namespace
}  // namespace analogon
