#include "core/base/text.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

std::vector<std::string> englishOf(const std::vector<Text>& texts) {
    std::vector<std::string> words;
    for (const Text& text : texts) words.push_back(text.english());
    return words;
}

TEST(Text, KeepsPatternAndArgumentsBesideTheEnglishWords) {
    const Text text = phrase("'{}' lies {:.1f} {} from {:.3g}", "heater.R", 3.14159, phrase("degrees"), 1234.5);
    EXPECT_EQ(text, "'heater.R' lies 3.1 degrees from 1.23e+03");
    EXPECT_EQ(text.pattern(), "'{}' lies {:.1f} {} from {:.3g}");
    EXPECT_EQ(englishOf(text.arguments()), (std::vector<std::string>{"heater.R", "3.1", "degrees", "1.23e+03"}));
    EXPECT_EQ(text.arguments()[2].pattern(), "degrees") << "an argument can be said in another language, too";
    EXPECT_TRUE(Text("heater.R").pattern().empty()) << "names are as they are";
}

TEST(Text, KnowsItsNumbers) {
    const Text text = phrase("{} of {} lies {:.1f} from {}", "R2.1", 3, 3.14159, 0.5);
    ASSERT_EQ(text.arguments().size(), 4u);
    EXPECT_FALSE(text.arguments()[0].isNumber()) << "a name";
    EXPECT_TRUE(text.arguments()[2].isNumber());
    EXPECT_TRUE(text.arguments()[3].isNumber());
    EXPECT_FALSE(text.isNumber());
    Text sequence = Text::number("0.5");
    EXPECT_TRUE(sequence.isNumber());
    sequence += " V";
    EXPECT_EQ(sequence, "0.5 V");
    EXPECT_FALSE(sequence.isNumber());
    EXPECT_TRUE(sequence.arguments().front().isNumber());
}

TEST(Text, KnowsTheFormatOfEachArgument) {
    EXPECT_EQ(formatsOf("{1:.2f} of {0} {{no}} {2:>3}", 3), (std::vector<std::string>{"", ".2f", ">3"}));
    EXPECT_EQ(formatsOf("plain", 0), std::vector<std::string>{});
    EXPECT_EQ(phrase("{{\"column\": \"{}\"}}", "u"), "{\"column\": \"u\"}");
}

TEST(Text, SentencesStandOneBehindTheOther) {
    Text text = phrase("the recording pauses for {} s", 3);
    text += Text();
    EXPECT_EQ(text.pattern(), "the recording pauses for {} s") << "nothing was added";
    text += phrase(" ({} gaps)", 2);
    text += phrase(".");
    EXPECT_EQ(text, "the recording pauses for 3 s (2 gaps).");
    EXPECT_TRUE(text.pattern().empty());
    ASSERT_EQ(text.arguments().size(), 3u);
    EXPECT_EQ(text.arguments()[1].pattern(), " ({} gaps)");
}

TEST(Text, ANameIsReplacedWhereverItStands) {
    Text text = phrase("there is no file '{}' in {}", "/tmp/x/a.csv", phrase("the directory {}", "/tmp/x/"));
    text.replaceAll("/tmp/x/", "study/");
    EXPECT_EQ(text, "there is no file 'study/a.csv' in the directory study/");
    EXPECT_EQ(text.arguments()[1].arguments()[0], "study/");
}

TEST(Text, ListsNames) {
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed({"R"}), "R");
    EXPECT_EQ(listed({"R", "k"}), "R and k");
    EXPECT_EQ(listed({"R", "k", "b"}), "R, k and b");
}

}  // namespace
}  // namespace analogon
