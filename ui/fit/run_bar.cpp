#include "ui/fit/run_bar.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "ui/fit/run_controller.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

/// What a run is doing, in words.
QString stageText(const QString& stage) {
    if (stage == "fit") return RunBar::tr("fitting");
    if (stage == "simulate") return RunBar::tr("simulating");
    if (stage == "screen") return RunBar::tr("looking at every effect");
    if (stage == "trial") return RunBar::tr("trying");
    if (stage == "reconsider") return RunBar::tr("weighing again");
    if (stage == "remove") return RunBar::tr("leaving out");
    if (stage == "propose") return RunBar::tr("looking for an equation");
    if (stage == "next experiment") return RunBar::tr("planning the next experiment");
    return stage;
}

}  // namespace

RunBar::RunBar(RunController& controller, QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      text_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new QToolButton(this)) {
    style::makeCaption(text_);
    text_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    text_->setMinimumWidth(60);
    text_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar_->setTextVisible(false);
    bar_->setFixedSize(160, 8);
    bar_->setRange(0, 1000);
    cancel_->setIcon(style::icon("cancel"));
    cancel_->setText(tr("Cancel"));
    cancel_->setToolTip(tr("Stop; the best result so far is kept (Esc)"));
    cancel_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    cancel_->setShortcut(Qt::Key_Escape);
    cancel_->setAutoRaise(true);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(style::margin, 0, style::unit, 0);
    layout->setSpacing(2 * style::unit);
    layout->addWidget(text_, 1);
    layout->addWidget(bar_);
    layout->addWidget(cancel_);

    connect(cancel_, &QToolButton::clicked, this, [this] {
        controller_.cancel();
        cancel_->setEnabled(false);
        text_->setText(tr("Stopping …"));
    });
    connect(&controller, &RunController::runningChanged, this, [this] {
        const JobRunner* const job = controller_.shownJob();
        const bool isRunning = job != nullptr;
        isSearching_ = false;
        text_->setText(job ? job->what() + QStringLiteral(" …") : QString());
        bar_->setRange(0, 0);
        bar_->setVisible(isRunning);
        cancel_->setVisible(isRunning);
        cancel_->setEnabled(true);
    });
    connect(&controller, &RunController::progressed, this, [this](const Progress::Report& report) {
        if (const JobRunner* const job = controller_.shownJob(); !job || job->isCancelling()) return;
        // The fits of single candidates, side by side, say nothing of how far the search is.
        isSearching_ = isSearching_ || (report.stage != "fit" && report.stage != "simulate");
        if (isSearching_ && report.stage == "fit") return;
        QString text = stageText(QString::fromStdString(report.stage));
        if (!report.detail.empty()) text += QStringLiteral(" · ") + inWords(report.detail);
        if (report.error >= 0) text += QStringLiteral(" · ") + tr("error %1 %").arg(style::numberText(report.error, 3));
        text_->setText(text_->fontMetrics().elidedText(text, Qt::ElideMiddle, text_->width()));
        text_->setToolTip(text);
        bar_->setRange(0, report.fraction < 0 ? 0 : 1000);
        if (report.fraction >= 0) bar_->setValue(static_cast<int>(report.fraction * 1000));
    });
    bar_->hide();
    cancel_->hide();
}

}  // namespace analogon::ui
