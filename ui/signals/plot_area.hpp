#pragma once

#include <QWidget>
#include <optional>
#include <set>
#include <vector>

#include "ui/signals/plot_layout.hpp"
#include "ui/signals/signal_values.hpp"

class QLabel;
class QScrollArea;
class QStackedLayout;
class QVBoxLayout;

namespace analogon::ui {

class Document;
class SignalStrip;

/// Plots of any signals of the study: axes above each other, all times linked. What is shown is part of the study, each
/// change of it an undoable step; the numbers come when they are there, and follow the study.
class PlotArea : public QWidget {
    Q_OBJECT

public:
    explicit PlotArea(Document& document, QWidget* parent = nullptr);

    /// On an axis of their own; those of a third unit on one more.
    void show(const std::vector<SignalRef>& references);
    void addTo(int axis, const std::vector<SignalRef>& references);
    const std::vector<SignalStrip*>& strips() const { return strips_; }
    SignalValues& values() { return values_; }
    const PlotLayout& layout() const { return layout_; }
    std::pair<double, double> timeRange() const { return {from_, to_}; }

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void change(PlotLayout layout, const QString& what);
    void takeLayout();
    void dropClosed(const PlotLayout& before);
    void makeStrips();
    void refresh();
    void setTimeRange(double from, double to);
    void pointAt(std::optional<double> time);
    void mark(double time);
    void remove(int axis, int trace);
    void move(int axis, int by);
    void closeAxis(int axis);
    /// Of an output while a parameter is turned or a fit runs; null: nothing moves.
    std::shared_ptr<const SignalData> moving(const SignalRef& reference, const SignalData& shown) const;
    QString unitOf(const SignalRef& reference);
    QColor colourOf(const SignalRef& reference, const std::set<QString>& taken);
    int axisOf(const SignalStrip* strip) const;

    Document& document_;
    SignalValues values_;
    PlotLayout layout_;
    std::vector<SignalStrip*> strips_;
    std::map<QString, std::shared_ptr<const SignalData>> shown_;  // stays until what follows it is there
    QStackedLayout* pages_;
    QLabel *empty_, *difference_;
    QWidget* page_;
    QScrollArea* area_;
    QVBoxLayout* column_;
    double from_{0}, to_{1}, first_{0}, last_{1};  // [s]
    bool isWhole_{true};
    std::vector<double> marks_;       // [s] at most two
    std::map<QString, int> colours_;  // by key, in the order in which signals came
};

}  // namespace analogon::ui
