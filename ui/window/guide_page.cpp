#include "ui/window/guide_page.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QPushButton>
#include <QResizeEvent>
#include <QScrollBar>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

/// A text whose pictures are as wide as its column at most.
class Browser : public QTextBrowser {
public:
    using QTextBrowser::QTextBrowser;
    void setText(const QString& markdown) {
        text_ = markdown;
        layOut();
    }

protected:
    QVariant loadResource(int type, const QUrl& name) override {
        if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
        QImage picture(QFileInfo(guideFile()).dir().filePath(name.path()));
        const double ratio = devicePixelRatioF();
        const int widest = std::min(760, viewport()->width() - 16 * style::unit);  // [px]
        if (picture.width() > widest * ratio)
            picture = picture.scaledToWidth(static_cast<int>(widest * ratio), Qt::SmoothTransformation);
        picture.setDevicePixelRatio(ratio);
        return picture;
    }
    void resizeEvent(QResizeEvent* event) override {
        QTextBrowser::resizeEvent(event);
        constexpr int worthIt = 24;  // [px]
        if (std::abs(event->size().width() - laidOutFor_) >= worthIt) layOut();
    }

private:
    void layOut() {
        laidOutFor_ = viewport()->width();
        const QScrollBar& bar = *verticalScrollBar();
        const double part = bar.maximum() > 0 ? bar.value() / static_cast<double>(bar.maximum()) : 0;
        setMarkdown(text_);
        verticalScrollBar()->setValue(static_cast<int>(part * verticalScrollBar()->maximum()));
    }
    QString text_;
    int laidOutFor_{};  // [px]
};

}  // namespace

QString guideFile() {
    const QStringList names{GuidePage::tr("user-guide.md"), QStringLiteral("user-guide.md")};  // in its language, else
    const QStringList places{QCoreApplication::applicationDirPath() + "/../share/doc/analogon/",
                             QStringLiteral(ANALOGON_SOURCE_EXAMPLES) + "/../docs/"};
    for (const QString& name : names)
        for (const QString& place : places)
            if (QFile::exists(place + name)) return place + name;
    return {};
}

GuidePage::GuidePage(QWidget* parent) : QWidget(parent), browser_(new Browser(this)) {
    browser_->setFrameShape(QFrame::NoFrame);
    browser_->setOpenExternalLinks(true);
    browser_->setAccessibleName(tr("User guide"));
    browser_->document()->setDocumentMargin(6 * style::unit);
    QFile file(guideFile());
    if (file.open(QIODevice::ReadOnly))
        static_cast<Browser*>(browser_)->setText(QString::fromUtf8(file.readAll()));
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
