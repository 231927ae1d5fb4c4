#include "core/report/diagram_svg.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace analogon {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
}

Block block(const std::string& name, Point origin) {
    Block made;
    made.name = name;
    made.placement.origin = origin;
    Primitive body, letter;
    body.kind = Primitive::Kind::Rectangle;
    body.extent = {{-80, -80}, {80, 80}};
    letter.kind = Primitive::Kind::Text;
    letter.extent = {{-60, -40}, {60, 40}};
    letter.text = "<M>";
    Primitive ownName = letter;
    ownName.text = "%name";
    made.icon.primitives = {body, letter, ownName};
    return made;
}

DiagramPair pair() {
    DiagramPair two;
    two.before.blocks = {block("motor", {0, 0}), block("rotor", {40, 0})};
    Wire wire;
    wire.points = {{10, 0}, {30, 0}};
    wire.colour = {0, 0, 255};
    two.before.wires = {wire};
    two.after = two.before;
    two.after.blocks.push_back(block("friction", {80, -20}));
    two.marks = {{"friction", "dry friction"}};
    return two;
}

TEST(DiagramPicture, ShowsTheBlocksBeforeAndAfterAndOutlinesWhatWasAdded) {
    const std::string page = diagramsHtml(pair());
    const std::string before = page.substr(0, page.find("After")), after = page.substr(page.find("After"));
    EXPECT_THAT(before, HasSubstr(">motor</text>"));
    EXPECT_THAT(before, Not(HasSubstr("friction")));
    EXPECT_THAT(before, Not(HasSubstr("class=\"mark\"")));
    EXPECT_THAT(after, HasSubstr("class=\"marked\">friction</text>"));
    EXPECT_EQ(count(after, "class=\"mark\""), 1u);
    EXPECT_THAT(after, HasSubstr("<code>friction</code> dry friction"));
    EXPECT_EQ(count(page, "stroke=\"#0000ff\""), 2u);
    // icon of 20 x 20 about (80, -20) and the gap of the outline
    EXPECT_THAT(after, HasSubstr("<rect x=\"67\" y=\"7\" width=\"26\" height=\"26\" class=\"mark\""));
}

TEST(DiagramPicture, SaysInWordsWhatItShows) {
    const std::string page = diagramsHtml(pair());
    EXPECT_EQ(count(page, "role=\"img\""), 2u);
    EXPECT_THAT(page, HasSubstr("aria-label=\"Diagram of the model with what was added: friction outlined\""));
}

TEST(DiagramPicture, HasEachIconOnceAndStaysSmall) {
    DiagramPair two = pair();
    for (int i = 0; i < 8; ++i) two.before.blocks.push_back(block(fmt::format("block{}", i), {20.0 * i, 60}));
    two.after.blocks = two.before.blocks;
    const std::string page = diagramsHtml(two);
    EXPECT_EQ(count(page, "<g id="), 1u);
    EXPECT_EQ(count(page, "<use href=\"#icon1\" stroke-width="), 20u);
    EXPECT_LT(page.size(), 20000u);
}

TEST(DiagramPicture, KeepsTextsUprightWhereABlockIsMirroredAndTurned) {
    DiagramPair two = pair();
    two.before.blocks[0].placement.extent = {{10, -10}, {-10, 10}};
    two.before.blocks[0].placement.rotation = 180;
    two.after = two.before;
    const std::string page = diagramsHtml(two);
    EXPECT_THAT(page, HasSubstr("matrix(0.1 0 0 0.1 0 0)"));  // mirrored twice: across by itself, and by the half turn
    EXPECT_EQ(page.find("<text"), page.find("<text x="));
    EXPECT_THAT(page, Not(HasSubstr("rotate(")));
}

TEST(DiagramPicture, EscapesWhatAnybodyWrote) {
    DiagramPair two = pair();
    two.after.blocks[2].name = "<script>&\"";
    two.marks = {{"<script>&\"", "<b>"}};
    const std::string page = diagramsHtml(two);
    EXPECT_THAT(page, Not(HasSubstr("<script>")));
    EXPECT_THAT(page, Not(HasSubstr("<b>")));
    EXPECT_THAT(page, HasSubstr("&lt;script&gt;&amp;&quot; outlined"));
    EXPECT_THAT(page, HasSubstr("&lt;M&gt;</text>"));
    EXPECT_THAT(page, Not(HasSubstr("%name")));
}

TEST(DiagramPicture, DrawsABoxForAnUnknownClassAndNothingBeyondWithoutBlocks) {
    DiagramPair two;
    Block unknown;
    unknown.name = "x";
    unknown.isResolved = false;
    two.after.blocks = {unknown};
    const std::string page = diagramsHtml(two);
    EXPECT_EQ(count(page, "class=\"unknown\""), 1u);
    EXPECT_THAT(page, HasSubstr("viewBox=\"-106 -106 212 212\""));  // of the empty one
}

TEST(DiagramDrawing, IsAFileOfItsOwnAsLargeAsOnPaper) {
    DiagramPair two = pair();
    const DiagramDrawings small = diagramDrawings(two);
    EXPECT_TRUE(small.areBeside);
    for (const DiagramDrawing* drawing : {&small.before, &small.after}) {
        EXPECT_THAT(drawing->svg, HasSubstr("<svg xmlns=\"http://www.w3.org/2000/svg\""));
        EXPECT_THAT(drawing->svg, HasSubstr("<g id=\"icon1\"")) << "its own symbols";
        EXPECT_THAT(drawing->svg, Not(HasSubstr("paint-order")));
        EXPECT_LE(drawing->width, 310);
    }
    EXPECT_EQ(count(small.after.svg, "stroke=\"#c2185b\""), 1u) << "the outline";
    EXPECT_EQ(count(small.before.svg, "#c2185b"), 0u);
    EXPECT_THAT(small.after.svg, HasSubstr("fill=\"#c2185b\" font-weight=\"bold\">friction</text>"));
    EXPECT_THAT(small.after.svg, Not(HasSubstr("class="))) << "no style of a page";
    two.after.blocks.push_back(block("far", {600, 0}));
    const DiagramDrawings wide = diagramDrawings(two);
    EXPECT_FALSE(wide.areBeside);
    EXPECT_GT(wide.after.width, 310);
    EXPECT_LE(wide.after.width, 640);
    two.after.blocks.push_back(block("low", {0, -3000}));
    EXPECT_LE(diagramDrawings(two).after.height, 381) << "a page holds both";
}

}  // namespace
}  // namespace analogon
