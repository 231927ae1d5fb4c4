#include "ui/effect/finding_words.hpp"

#include <gtest/gtest.h>

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

}  // namespace analogon::ui
