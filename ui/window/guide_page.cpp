#include "ui/window/guide_page.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QImageReader>
#include <QPushButton>
#include <QResizeEvent>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "ui/job/job.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

using Pictures = std::map<QString, QImage>;  // by file

/// A picture's size in device pixels when it is no wider than that.
QSize fitted(QSize size, int widest) {
    return size.width() > widest ? QSize(widest, size.height() * widest / size.width()) : size;
}

/// A text whose pictures are as wide as its column at most. They are read in the background, one after the other; until
/// then there is room for them.
class Browser : public QTextBrowser {
public:
    explicit Browser(QWidget* parent) : QTextBrowser(parent) {
        resized_.setSingleShot(true);
        connect(&resized_, &QTimer::timeout, this, &Browser::layOut);
    }
    void setText(const QString& markdown) {
        text_ = markdown;
        layOut();
    }

protected:
    QVariant loadResource(int type, const QUrl& name) override {
        if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
        const QSize size = fitted(QImageReader(fileOf(name)).size(), widest());
        if (size.isEmpty()) return {};
        const auto found = pictures_.find(fileOf(name));
        if (found != pictures_.end() && found->second.size() == size) return shown(found->second);
        if (wanted_.isEmpty() && !reader_.isBusy()) QTimer::singleShot(0, this, &Browser::readNext);
        if (!wanted_.contains(name)) wanted_ << name;
        QImage room(size, QImage::Format_ARGB32_Premultiplied);
        room.fill(Qt::transparent);
        return shown(room);
    }
    void changeEvent(QEvent* event) override {
        QTextBrowser::changeEvent(event);
        if (event->type() == QEvent::PaletteChange && shown_) resized_.start(0);
    }
    void resizeEvent(QResizeEvent* event) override {
        QTextBrowser::resizeEvent(event);
        constexpr int worthIt = 24;  // [px]
        constexpr int pause = 150;   // [ms] a border that is dragged changes the width many times
        if (std::abs(event->size().width() - laidOutFor_) >= worthIt) resized_.start(pause);
    }

private:
    int widest() const {  // [device px]
        const int column = std::max(40, std::min(760, viewport()->width() - 16 * style::unit));
        return static_cast<int>(column * devicePixelRatioF());
    }
    /// The picture in the look of the window, where there is one.
    QString fileOf(const QUrl& name) const {
        const QString file = QFileInfo(guideFile()).dir().filePath(name.path());
        const QString dark = QString(file).replace(QStringLiteral(".png"), QStringLiteral("-dark.png"));
        return style::isDark(palette()) && QFileInfo::exists(dark) ? dark : file;
    }
    QImage shown(QImage picture) const {
        picture.setDevicePixelRatio(devicePixelRatioF());
        return picture;
    }
    void readNext() {
        if (wanted_.isEmpty() || reader_.isBusy()) return;
        const QUrl name = wanted_.takeFirst();
        reader_.start<QImage>(
            QString(),
            [file = fileOf(name), width = widest()](const Progress&) {
                const QImage picture(file);
                return picture.scaled(fitted(picture.size(), width), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
            },
            [this, name](const QImage& picture) {
                pictures_[fileOf(name)] = picture;
                document()->addResource(QTextDocument::ImageResource, name, shown(picture));
                viewport()->update();
                QTimer::singleShot(0, this, &Browser::readNext);
            });
    }
    /// Of code, too: else one long line makes all of the page wider than its column.
    static void breakLongLines(QTextDocument& document) {
        QTextBlockFormat breaking;
        breaking.setNonBreakableLines(false);
        for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
            if (block.blockFormat().nonBreakableLines()) QTextCursor(block).mergeBlockFormat(breaking);
    }
    void layOut() {
        laidOutFor_ = viewport()->width();
        const QScrollBar& bar = *verticalScrollBar();
        const double part = bar.maximum() > 0 ? bar.value() / static_cast<double>(bar.maximum()) : 0;
        // Read into a document that nobody shows yet: one on the screen is laid out anew with every word.
        auto* next = new QTextDocument(this);
        next->setDefaultFont(font());
        next->setDocumentMargin(6 * style::unit);
        next->setMarkdown(text_);
        breakLongLines(*next);
        setDocument(next);
        delete shown_;
        shown_ = next;
        verticalScrollBar()->setValue(static_cast<int>(part * verticalScrollBar()->maximum()));
    }
    QString text_;
    QTextDocument* shown_{};
    QTimer resized_;
    Pictures pictures_;
    QList<QUrl> wanted_;  // still to be read
    JobRunner reader_;
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
