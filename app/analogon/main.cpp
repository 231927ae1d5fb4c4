#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QLocale>
#include <QProcess>
#include <QSettings>

#include "core/base/blas_threads.hpp"
#include "core/base/guard.hpp"
#include "core/base/memory.hpp"
#include "ui/style/style.hpp"
#include "ui/style/translator.hpp"
#include "ui/window/main_window.hpp"
#include "ui/window/pictures.hpp"

namespace {

/// Called before the libraries of the program prepare themselves.
void begin(int, char** arguments, char** environment) { analogon::askForOneBlasThread(arguments, environment); }
__attribute__((section(".preinit_array"), used)) void (*atTheBeginning)(int, char**, char**) = begin;

}  // namespace

int main(int argc, char** argv) {
    using namespace analogon;
    guardProgram();
    growHeap();
    const StackGuard stack;
    // Pictures need no screen; the platform is chosen before the application starts.
    for (int i = 1; i < argc; ++i)
        if (QByteArray(argv[i]).startsWith("--pictures") && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
            qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName("Analogon");
    QCoreApplication::setApplicationName("Analogon");
    QCoreApplication::setApplicationVersion(ANALOGON_VERSION);
    QGuiApplication::setDesktopFileName("org.analogon.Analogon");
    QGuiApplication::setWindowIcon(QIcon(":/icons/analogon.svg"));

    QCommandLineParser parser;
    parser.setApplicationDescription("Physical models of automotive components from test-bench measurements");
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("study", "A study: a directory, its study.json or an .analogon file.", "[study]");
    const QCommandLineOption language("language", "Language of the screen: en or de.", "code");
    const QCommandLineOption pictures("pictures", "Writes pictures of every panel into a directory and ends.", "dir");
    parser.addOptions({language, pictures});
    parser.process(application);
    if (parser.isSet(pictures)) {
        bool isWhole = ui::writePictures(parser.value(pictures), parser.value(language));
        if (qEnvironmentVariableIsSet("QT_SCALE_FACTOR")) return isWhole ? 0 : 1;
        for (const char* scale : {"1.5", "2"}) {  // a scale is that of a process: the large ones by others
            qputenv("QT_SCALE_FACTOR", scale);
            isWhole =
                QProcess::execute(QCoreApplication::applicationFilePath(), QCoreApplication::arguments().mid(1)) == 0 &&
                isWhole;
        }
        return isWhole ? 0 : 1;
    }

    const QString code = parser.isSet(language)
                             ? parser.value(language)
                             : QSettings().value("window/language", QLocale().name().left(2)).toString();
    ui::Translator translator;
    if (translator.loadLanguage(code)) QCoreApplication::installTranslator(&translator);

    ui::style::apply(application, static_cast<ui::style::Theme>(QSettings().value("window/theme", 0).toInt()));
    ui::MainWindow window;
    window.show();
    if (!parser.positionalArguments().isEmpty()) window.open(parser.positionalArguments().front());
    return QApplication::exec();
}
