#include "ui/effect/report_diagrams.hpp"

#include <QImage>
#include <QPainter>
#include <QSvgRenderer>
#include <QTextDocument>
#include <QUrl>

#include "ui/effect/finding_words.hpp"
#include "ui/effect/result_panel.hpp"

namespace analogon::ui {

namespace {

constexpr int dotsPerPixel = 4;  // some 400 in an inch
constexpr const char *pictureBefore = "diagram:before", *pictureAfter = "diagram:after";

QImage paintedPicture(const DiagramDrawing& drawing) {
    QSvgRenderer renderer(QByteArray::fromStdString(drawing.svg));
    QImage image((QSizeF(drawing.width, drawing.height) * dotsPerPixel).toSize().expandedTo({1, 1}),
                 QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    renderer.render(&painter);
    return image;
}

QString captionedPicture(const QString& caption, const char* picture, const DiagramDrawing& drawing) {
    return QStringLiteral("<p><b>%1</b></p><p><img src='%2' width='%3' height='%4'></p>")
        .arg(caption, picture)
        .arg(qRound(drawing.width))
        .arg(qRound(drawing.height));
}

}  // namespace

QString diagramsOnPaper(const DiagramPair& pair) {
    const DiagramDrawings drawings = diagramDrawings(pair);
    const QString before = captionedPicture(ResultPanel::tr("Before"), pictureBefore, drawings.before),
                  after = captionedPicture(ResultPanel::tr("After"), pictureAfter, drawings.after);
    QString html = "<h2>" + ResultPanel::tr("The model before and after") + "</h2>";
    if (drawings.areBeside)
        html += "<table width='100%' cellspacing='0'><tr><td width='50%'>" + before + "</td><td width='50%'>" + after +
                "</td></tr></table>";
    else
        html += before + after;
    for (const DiagramMark& mark : pair.marks)
        html += QStringLiteral("<p><span style='color: #c2185b'><b>▢&nbsp;%1</b></span> %2</p>")
                    .arg(QString::fromStdString(mark.block).toHtmlEscaped(),
                         shortDescription(QString::fromStdString(mark.words)).toHtmlEscaped());
    return html;
}

void addDiagrams(QTextDocument& document, const DiagramPair& pair) {
    const DiagramDrawings drawings = diagramDrawings(pair);
    document.addResource(QTextDocument::ImageResource, QUrl(pictureBefore), paintedPicture(drawings.before));
    document.addResource(QTextDocument::ImageResource, QUrl(pictureAfter), paintedPicture(drawings.after));
}

}  // namespace analogon::ui
