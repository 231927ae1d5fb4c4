#include "ui/effect/report_top.hpp"

#include <QDate>
#include <QFile>
#include <QPainter>
#include <QSvgRenderer>

#include "ui/effect/result_panel.hpp"
#include "ui/style/number.hpp"

namespace analogon::ui {

namespace {

constexpr int shownHeight = 48, sharpness = 4;  // [px] of the page, and pixels of the picture for one of them

QString told(const std::string& words) { return QString::fromStdString(words).toHtmlEscaped(); }

}  // namespace

QString reportTop(const QString& study, const ReportHead& head, bool hasLogo) {
    QStringList facts;
    const auto add = [&](const QString& label, const QString& words) {
        if (!words.isEmpty())
            facts << QStringLiteral("<span style='color: #666'>%1:</span>&nbsp;<b>%2</b>")
                         .arg(label, QString(words).replace(" ", "&nbsp;"));  // it stays in a line
    };
    add(ResultPanel::tr("Test object"), told(head.testObject));
    if (!head.title.empty()) add(ResultPanel::tr("Study"), study.toHtmlEscaped());
    add(ResultPanel::tr("Author"), told(head.author));
    add(ResultPanel::tr("Date"), told(head.date));
    QString html;
    if (hasLogo)
        html += QStringLiteral("<p align='right'><img src='%1' height='%2'></p>").arg(logoResource).arg(shownHeight);
    html += "<h1>" + (head.title.empty() ? study.toHtmlEscaped() : told(head.title)) + "</h1>";
    if (facts.isEmpty())
        return html + "<p>" + style::windowLocale().toString(QDate::currentDate(), QLocale::LongFormat) + "</p>";
    return html + "<p>" + facts.join(" &nbsp; ") + "</p>";
}

QImage logoPicture(const QString& file) {
    QFile source(file);
    if (file.isEmpty() || !source.open(QIODevice::ReadOnly)) return {};
    const QByteArray bytes = source.readAll();
    if (const QImage image = QImage::fromData(bytes); !image.isNull()) {
        const int height = shownHeight * sharpness;
        return image.height() > height ? image.scaledToHeight(height, Qt::SmoothTransformation) : image;
    }
    QSvgRenderer drawing(bytes);
    const QSizeF size = drawing.defaultSize();
    if (!drawing.isValid() || size.isEmpty()) return {};
    constexpr double longest = 4000;  // [px]
    const double height = shownHeight * sharpness, width = std::min(longest, height * size.width() / size.height());
    QImage image(QSize(std::max(1, qRound(width)), qRound(height)), QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    drawing.render(&painter);
    return image;
}

}  // namespace analogon::ui
