#include "ui/signals/signal_strip.hpp"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLabel>
#include <QTest>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextDocumentFragment>
#include <QTextLayout>
#include <QTextOption>
#include <QToolButton>

#include "ui/style/breakable.hpp"
#include "ui/style/style.hpp"
#include "ui/style/translator.hpp"

namespace analogon::ui {

/// At 1024 pixels the plots are less than 400 wide: the buttons of an axis are in them, however long its legend is.
TEST(SignalStrip, KeepsItsButtonsInANarrowPanelInEachLanguage) {
    for (const QString& language : languages()) {
        Translator translator;
        if (translator.loadLanguage(language)) QCoreApplication::installTranslator(&translator);
        SignalStrip strip;
        ChartLine line;
        line.reference = {SignalKind::Residual, "a long name of a recording",
                          "element_of_the_sensor.solid_temperature"};
        strip.setLines({line, line}, true);
        EXPECT_LE(strip.minimumSizeHint().width(), 380) << language.toStdString();
        strip.resize(380, 200);
        strip.show();
        const auto* close = strip.findChild<QToolButton*>("strip-close");
        EXPECT_LE(close->geometry().right(), strip.width()) << language.toStdString();
        QCoreApplication::removeTranslator(&translator);
    }
}

/// With figures between two cursors in German, whose words are the longest.
TEST(SignalStrip, CutsNoFigureOfALegendInANarrowPanel) {
    Translator german;
    ASSERT_TRUE(german.loadLanguage("de"));
    QCoreApplication::installTranslator(&german);
    {
        SignalStrip strip;
        std::vector<double> time(100), values(100);
        for (std::size_t i = 0; i < time.size(); ++i) {
            time[i] = static_cast<double>(i);
            values[i] = 291.15 + 1e-2 * static_cast<double>(i * i);
        }
        ChartLine line;
        line.reference = {SignalKind::Recorded, "a", "T_exhaust"};
        line.data = std::make_shared<const SignalData>(
            SignalData{std::make_shared<const std::vector<double>>(time), Series(values), "degC", {}});
        strip.setLines({line, line}, false);
        strip.setMarks({10, 70});
        strip.resize(380, 260);
        strip.show();
        QTest::qWait(20);
        int legends = 0;
        for (const QLabel* legend : strip.findChildren<QLabel*>()) {
            if (!legend->text().contains("▬")) continue;
            ++legends;
            QTextDocument document;
            document.setDocumentMargin(0);
            document.setDefaultFont(legend->font());
            document.setHtml(legend->text());
            document.setTextWidth(legend->contentsRect().width());
            EXPECT_LE(document.idealWidth(), legend->contentsRect().width()) << "no line is wider than the legend";
            EXPECT_GE(legend->height(), static_cast<int>(document.size().height()));
            for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
                for (int i = 0; i < block.layout()->lineCount(); ++i) {
                    const QTextLine shown = block.layout()->lineAt(i);
                    const QChar first = block.text().at(shown.textStart());
                    EXPECT_FALSE(first.isSpace()) << "each line begins at the left";
                }
        }
        EXPECT_EQ(legends, 1);
    }
    QCoreApplication::removeTranslator(&german);
}

/// What a legend says, in a picture of it: each letter is drawn within it.
TEST(SignalStrip, LosesNoWordOfALegendThatIsLongerThanThePlotIsWide) {
    for (const char* name :
         {"BasicElectricMechanical_of_the_first_pump.rotor.flange_a.tau", "averylongwordwithoutanysign", "short"}) {
        const QString html = breakable(name);
        QLabel legend;
        legend.setTextFormat(Qt::RichText);
        legend.setWordWrap(true);
        legend.setText(html);
        const int narrow = 24 * style::unit;
        QTextDocument document;
        document.setDocumentMargin(0);
        document.setDefaultFont(legend.font());
        QTextOption option;
        option.setWrapMode(QTextOption::WordWrap);
        document.setDefaultTextOption(option);
        document.setHtml(html);
        document.setTextWidth(narrow);
        EXPECT_LE(document.idealWidth(), narrow) << name;
        EXPECT_GE(legend.heightForWidth(narrow), static_cast<int>(document.size().height())) << name;
        EXPECT_EQ(QTextDocumentFragment::fromHtml(html).toPlainText().remove(QChar(0x200B)), name);
    }
    EXPECT_EQ(breakable("heater.alpha", 12), "heater.alpha") << "where there is room for it";
    EXPECT_TRUE(breakable("heater.alpha", 11).contains(QChar(0x200B)));
    EXPECT_EQ(breakable("a<b"), QString("a&lt;") + QChar(0x200B) + "b");
}

}  // namespace analogon::ui
