#include "ui/window/report_folder.hpp"

#include <QFileInfo>

#include "core/study/results.hpp"

namespace analogon::ui {

ReportFolderDialog::ReportFolderDialog(QWidget* parent, const QString& title) : QFileDialog(parent, title) {
    setFileMode(QFileDialog::AnyFile);
    setAcceptMode(QFileDialog::AcceptSave);
    setOption(QFileDialog::ShowDirsOnly);
    setLabelText(QFileDialog::FileName, tr("Directory:"));
    setLabelText(QFileDialog::Accept, tr("Write"));
}

void ReportFolderDialog::setProposal(const QString& name) {
    proposal_ = name;
    selectFile(name);
}

void ReportFolderDialog::accept() {
    const QStringList chosen = selectedFiles();
    if (chosen.size() != 1 || !QFileInfo(chosen.front()).isDir()) return QFileDialog::accept();
    const QString path = chosen.front();
    if (ResultsPlace::take(path.toStdString())) {  // empty, or with an earlier report
        Q_EMIT fileSelected(path);
        return done(QDialog::Accepted);
    }
    setDirectory(path);
    selectFile(proposal_);
}

}  // namespace analogon::ui
