#include "ui/window/guide_page.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

/// Pictures no wider than a column of text.
class Browser : public QTextBrowser {
public:
    using QTextBrowser::QTextBrowser;

protected:
    QVariant loadResource(int type, const QUrl& name) override {
        if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
        const QImage picture(QFileInfo(guideFile()).dir().filePath(name.path()));
        constexpr int widest = 760;  // [px]
        return picture.width() > widest ? picture.scaledToWidth(widest, Qt::SmoothTransformation) : picture;
    }
};

}  // namespace

QString guideFile() {
    for (const QString& place : {QCoreApplication::applicationDirPath() + "/../share/doc/analogon/user-guide.md",
                                 QStringLiteral(ANALOGON_SOURCE_EXAMPLES) + "/../docs/user-guide.md"})
        if (QFile::exists(place)) return place;
    return {};
}

GuidePage::GuidePage(QWidget* parent) : QWidget(parent), browser_(new Browser(this)) {
    browser_->setFrameShape(QFrame::NoFrame);
    browser_->setOpenExternalLinks(true);
    browser_->setAccessibleName(tr("User guide"));
    browser_->document()->setDocumentMargin(6 * style::unit);
    QFile file(guideFile());
    if (file.open(QIODevice::ReadOnly))
        browser_->setMarkdown(QString::fromUtf8(file.readAll()));
    else
        browser_->setPlainText(tr("The guide is not installed."));
    auto* close = new QPushButton(tr("Close the guide"), this);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(style::margin, style::unit, style::margin, style::unit);
    row->addStretch(1);
    row->addWidget(close);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(browser_, 1);
    layout->addLayout(row);
    connect(close, &QPushButton::clicked, this, &GuidePage::left);
}

}  // namespace analogon::ui
