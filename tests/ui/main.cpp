#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QSettings>
#include <QTemporaryDir>
#include <optional>

#include "ui/style/style.hpp"

namespace {

/// Nothing that one test leaves is there when the next begins: what its windows remembered from one start of the
/// program to the next (which panels are closed, where their borders are, theme and language), and what the process
/// keeps.
class CleanStart : public testing::EmptyTestEventListener {
    void OnTestStart(const testing::TestInfo&) override {
        QSettings().clear();
        QGuiApplication::clipboard()->clear();
        QDir::setCurrent(startedIn_);
        if (analogon::ui::style::current() != analogon::ui::style::Theme::Light)
            analogon::ui::style::apply(*qApp, analogon::ui::style::Theme::Light);
    }
    const QString startedIn_ = QDir::currentPath();
};

}  // namespace

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
    if (own) testing::UnitTest::GetInstance()->listeners().Append(new CleanStart);  // takes it over
    return RUN_ALL_TESTS();
}
