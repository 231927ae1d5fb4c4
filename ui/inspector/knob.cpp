#include "ui/inspector/knob.hpp"

#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/study/parameter_glance.hpp"
#include "ui/document/document.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

constexpr int steps = 1000;  // of the slider

const ParameterFact* factOf(const Document& document, const std::string& parameter) {
    for (const ParameterFact& fact : document.facts().parameters)
        if (fact.name == parameter) return &fact;
    return nullptr;
}

/// As many digits as the slider tells apart.
double toFiveDigits(double value) { return QString::number(value, 'g', 5).toDouble(); }

}  // namespace

double KnobRange::valueAt(double part) const {
    return isLogarithmic ? low * std::pow(high / low, part) : low + part * (high - low);
}

double KnobRange::partOf(double value) const {
    const double part =
        isLogarithmic ? std::log(std::max(value, low) / low) / std::log(high / low) : (value - low) / (high - low);
    return std::clamp(part, 0.0, 1.0);
}

KnobRange knobRange(double value, std::optional<double> min, std::optional<double> max, ParameterScale scale) {
    constexpr double manyTimes = 10;
    if (min && max && *max > *min) {
        const bool isManyTimes = *min > 0 && *max / *min > manyTimes;
        return {
            *min, *max,
            *min > 0 && (scale == ParameterScale::Logarithmic || (scale == ParameterScale::Automatic && isManyTimes))};
    }
    if (value == 0) return {min.value_or(-1), std::max(max.value_or(1), min.value_or(-1) + 1), false};
    const double half = std::sqrt(manyTimes);
    double near = value / half, far = value * half;
    if (max && value > 0) far = std::max(std::min(far, *max), value);
    if (min && value > 0) near = std::min(std::max(near, *min), value);
    if (value < 0) return {far, near, false};
    return {near, far, near > 0};
}

Knob::Knob(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      name_(new QLabel),
      number_(new QLabel),
      slider_(new QSlider(Qt::Horizontal)) {
    slider_->setRange(0, steps);
    slider_->setSingleStep(steps / 100);
    slider_->setPageStep(steps / 20);
    slider_->setFocusPolicy(Qt::StrongFocus);
    slider_->setToolTip(
        tr("Drag: the traces show what the parameter does. Arrows step; so does the wheel once the slider "
           "has the focus."));
    auto* head = new QHBoxLayout;
    head->addWidget(name_, 1);
    head->addWidget(number_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(style::margin, style::unit, style::margin, style::unit);
    column->setSpacing(0);
    column->addLayout(head);
    column->addWidget(slider_);
    constexpr int pause = 400;  // [ms]
    rest_.setSingleShot(true);
    rest_.setInterval(pause);
    connect(&rest_, &QTimer::timeout, this, &Knob::commit);
    connect(slider_, &QSlider::valueChanged, this, &Knob::move);
    connect(slider_, &QSlider::sliderReleased, this, &Knob::commit);
    for (auto changed : {&Document::opened, &Document::factsChanged, &Document::parametersChanged})
        connect(&document, changed, this, &Knob::refresh);
    connect(&document, &Document::resultChanged, this, [this] {
        if (!std::exchange(isSettling_, false) || isTurning_) return;
        document_.setPreview(std::nullopt);
    });
    hide();
}

Knob::~Knob() = default;

void Knob::turn(const std::string& parameter) {
    if (parameter == parameter_) return;
    if (isTurning_) commit();
    parameter_ = parameter;
    refresh();
}

double Knob::value() const { return range_.valueAt(static_cast<double>(slider_->value()) / steps); }

void Knob::refresh() {
    if (isTurning_) return;
    const std::optional<double> value =
        document_.isOpen() && !parameter_.empty() ? document_.parameterValue(parameter_) : std::nullopt;
    const ParameterFact* fact = value ? factOf(document_, parameter_) : nullptr;
    setVisible(fact && std::isfinite(*value));
    if (!fact) return;
    const auto setting = document_.study().parameters.find(parameter_);
    const StudyParameter told = setting == document_.study().parameters.end() ? StudyParameter{} : setting->second;
    range_ = knobRange(*value, told.min ? told.min : fact->min, told.max ? told.max : fact->max, told.scale);
    name_->setText(QString::fromStdString(parameter_));
    const QSignalBlocker blocker(slider_);
    slider_->setAccessibleName(name_->text());
    slider_->setValue(static_cast<int>(std::lround(range_.partOf(*value) * steps)));
    write(*value);
}

void Knob::write(double value) {
    const ParameterFact* fact = factOf(document_, parameter_);
    const QString unit = fact && fact->unit != "1" ? QString::fromStdString(fact->unit) : QString();
    number_->setText(unit.isEmpty() ? style::numberText(value) : style::numberText(value) + ' ' + unit);
}

QString Knob::text() const { return name_->text() + " = " + number_->text(); }

void Knob::move() {
    isTurning_ = true;
    write(value());
    wanted_ = toFiveDigits(value());
    simulate();
    if (!slider_->isSliderDown()) rest_.start();
}

void Knob::commit() {
    rest_.stop();
    if (!std::exchange(isTurning_, false)) return;
    isSettling_ = true;
    const double now = toFiveDigits(value());
    if (now != document_.parameterValue(parameter_)) document_.setParameterValue(parameter_, now);
}

/// One after the other: of several values that have come meanwhile the last one is looked at.
void Knob::simulate() {
    if (worker_.isBusy() || !wanted_ || !document_.isOpen()) return;
    if (!glance_ || glanceOf_ != parameter_ || glanceRevision_ != document_.revision()) {
        glanceOf_ = parameter_;
        glanceRevision_ = document_.revision();
        return worker_.start<Outcome<ParameterGlance>>(
            tr("Simulating"),
            [study = document_.study(), parameter = parameter_](const Progress& progress) {
                return ParameterGlance::make(study, parameter, progress);
            },
            [this](Outcome<ParameterGlance> glance) {
                glance_ = glance ? std::make_shared<const ParameterGlance>(std::move(*glance)) : nullptr;
                if (glance_)
                    simulate();
                else
                    wanted_.reset();
            });
    }
    const double value = *std::exchange(wanted_, std::nullopt);
    worker_.start<std::optional<SimulatedTraces>>(
        tr("Simulating"), [glance = glance_, value](const Progress& progress) { return glance->at(value, progress); },
        [this](std::optional<SimulatedTraces> traces) {
            if (traces && (isTurning_ || isSettling_)) {
                ++pictures_;
                document_.setPreview(Document::Preview{text(), std::move(*traces)});
            }
            simulate();
        });
}

}  // namespace analogon::ui
