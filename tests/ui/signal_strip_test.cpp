#include "ui/signals/signal_strip.hpp"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLabel>
#include <QTextDocument>
#include <QTextDocumentFragment>
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
