#include "ui/window/recovered_line.hpp"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace analogon::ui {

RecoveredLine::RecoveredLine(Recovered recovered, QWidget* parent) : QWidget(parent) {
    // "study.json" says nothing without its folder.
    const QFileInfo file(recovered.path);
    const QString name =
        recovered.path.isEmpty() ? tr("A study that was never saved") : file.dir().dirName() + u'/' + file.fileName();
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    auto* open = new QPushButton(tr("Open"), this);
    auto* drop = new QPushButton(tr("Discard"), this);
    connect(open, &QPushButton::clicked, this, [this, recovered] { Q_EMIT chosen(recovered); });
    connect(drop, &QPushButton::clicked, this, [this, recovered] {
        Recovery::discard(recovered);
        hide();
        Q_EMIT discarded();
    });
    row->addWidget(new QLabel(tr("%1, changes of %2").arg(name, recovered.saved), this), 1);
    row->addWidget(open);
    row->addWidget(drop);
}

}  // namespace analogon::ui
