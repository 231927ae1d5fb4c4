#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>

#include "ui/style/style.hpp"

// Discovery of the tests runs this program too, so the platform is chosen here and not in CMake.
int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    testing::InitGoogleTest(&argc, argv);
    const QTemporaryDir settings;  // the user's own settings stay out of the tests, and the tests out of them
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    qputenv("XDG_DATA_HOME", settings.path().toUtf8());  // nor does one offer what another has left
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName("Analogon");
    QCoreApplication::setApplicationName("AnalogonTest");
    analogon::ui::style::apply(application, analogon::ui::style::Theme::Light);
    return RUN_ALL_TESTS();
}
