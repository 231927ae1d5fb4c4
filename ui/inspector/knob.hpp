#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>

#include "core/fit/problem.hpp"
#include "ui/job/job.hpp"

class QLabel;
class QSlider;

namespace analogon {
class ParameterGlance;
}

namespace analogon::ui {

class Document;

/// Over which values a knob is turned.
struct KnobRange {
    double low{}, high{};
    bool isLogarithmic{};

    double valueAt(double part) const;  // part: 0 … 1
    double partOf(double value) const;  // within 0 … 1
};

/// From bound to bound where there are both, else a decade about the value. A range of many decades of one sign is
/// logarithmic, as a fit searches it.
KnobRange knobRange(double value, std::optional<double> min, std::optional<double> max, ParameterScale scale);

/// A slider for one parameter: while it is dragged the traces show what it does, with their errors; where it is let go
/// the parameter is set, as one step of undo. Arrows step; the wheel does so where the slider has the focus.
class Knob : public QWidget {
    Q_OBJECT

public:
    explicit Knob(Document& document, QWidget* parent = nullptr);
    ~Knob() override;

    /// Empty: none.
    void turn(const std::string& parameter);
    QSlider* slider() const { return slider_; }
    QString text() const;
    /// Pictures shown since the program began.
    int pictures() const { return pictures_; }

private:
    void refresh();
    void move();
    void commit();
    void simulate();
    void write(double value);
    double value() const;

    Document& document_;
    std::string parameter_;
    KnobRange range_;
    QLabel *name_, *number_;
    QSlider* slider_;
    QTimer rest_;                      // until steps by keys are one change
    bool isTurning_{}, isSettling_{};  // settling: the study is simulated anew
    std::optional<double> wanted_;     // value to be looked at next
    std::shared_ptr<const ParameterGlance> glance_;
    std::string glanceOf_;
    unsigned long glanceRevision_{};
    JobRunner worker_;
    int pictures_{};
};

}  // namespace analogon::ui
