#include "ui/signals/signal_strip.hpp"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QToolButton>

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

}  // namespace analogon::ui
