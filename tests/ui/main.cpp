#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <optional>

#include "ui/style/style.hpp"

// Discovery of the tests runs this program too, so the platform is chosen here and not in CMake.
int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    testing::InitGoogleTest(&argc, argv);
    // The user's own settings stay out of the tests, and the tests out of them; nor does one offer what another has
    // left. A process that a test starts has the directory of that test.
    QString home = qEnvironmentVariable("ANALOGON_TEST_HOME");
    std::optional<QTemporaryDir> own;
    if (home.isEmpty()) home = own.emplace().path();
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home);
    qputenv("XDG_DATA_HOME", home.toUtf8());
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName("Analogon");
    QCoreApplication::setApplicationName("AnalogonTest");
    analogon::ui::style::apply(application, analogon::ui::style::Theme::Light);
    return RUN_ALL_TESTS();
}
