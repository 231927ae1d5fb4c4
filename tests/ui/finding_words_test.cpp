#include "ui/effect/finding_words.hpp"

#include <gtest/gtest.h>

#include <QCoreApplication>

#include "ui/style/translator.hpp"

namespace analogon::ui {

TEST(FindingWords, SpeakOfSeveralEffectsAsSeveral) {
    Finding finding;
    for (const FindingKind kind : {FindingKind::Effect, FindingKind::Partial}) {
        finding.kind = kind;
        finding.effects.resize(1);
        EXPECT_TRUE(findingWords(finding, RunKind::Discover).sentence.startsWith("With it,"));
        finding.effects.resize(2);
        EXPECT_EQ(findingWords(finding, RunKind::Discover).title, "2 effects");
        EXPECT_TRUE(findingWords(finding, RunKind::Discover).sentence.startsWith("With them,"));
    }
}

TEST(FindingWords, SayWhyNoEffectWasLookedForBesideAWrongReading) {
    Finding finding;
    finding.kind = FindingKind::Unexplained;
    finding.end.notSearched = phrase("{} and {} seem to be exchanged", "T_in", "T_out");
    EXPECT_EQ(findingWords(finding, RunKind::Discover).title, "No effect was looked for");
    finding.unexplained.remainders.resize(1);
    EXPECT_EQ(findingWords(finding, RunKind::Discover).title, "A recording is not what it says");
    EXPECT_EQ(findingWords(finding, RunKind::Discover).sentence, "T_in and T_out seem to be exchanged");
}

TEST(FindingWords, NameThePlaceOfAnEffectInTheLanguageOfTheScreen) {
    EXPECT_EQ(placeText("shell", "gas_flow"), "shell by channel gas_flow");
    EXPECT_EQ(placeText("heater.heatPort", "input T_amb"), "heater.heatPort by input T_amb");
    Translator german;
    ASSERT_TRUE(german.loadLanguage("de"));
    QCoreApplication::installTranslator(&german);
    EXPECT_EQ(placeText("heater.heatPort", "input T_amb").toStdString(), "heater.heatPort durch Eingang T_amb");
    EXPECT_EQ(placeText("output y").toStdString(), "Ausgang y");
    QCoreApplication::removeTranslator(&german);
}

}  // namespace analogon::ui
