#include <QApplication>
#include <QCommandLineParser>
#include <QSettings>

#include "ui/style/style.hpp"
#include "ui/window/main_window.hpp"

int main(int argc, char** argv) {
    using namespace analogon;
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName("Analogon");
    QCoreApplication::setApplicationName("Analogon");
    QCoreApplication::setApplicationVersion(ANALOGON_VERSION);

    QCommandLineParser parser;
    parser.setApplicationDescription("Physical models of automotive components from test-bench measurements");
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("study", "A study: a directory, its study.json or an .analogon file.", "[study]");
    parser.process(application);

    ui::style::apply(application, static_cast<ui::style::Theme>(QSettings().value("window/theme", 0).toInt()));
    ui::MainWindow window;
    window.show();
    if (!parser.positionalArguments().isEmpty()) window.open(parser.positionalArguments().front());
    return QApplication::exec();
}
