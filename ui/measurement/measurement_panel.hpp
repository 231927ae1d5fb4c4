#pragma once

#include <QStringList>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/study/study.hpp"
#include "ui/document/model_facts.hpp"
#include "ui/job/job.hpp"

class QLabel;
class QMenu;
class QToolButton;
class QStackedLayout;
class QTreeWidget;
class QTreeWidgetItem;

namespace analogon::ui {

class Document;
struct RecordingExtent;
}  // namespace analogon::ui
namespace analogon {
struct Table;
}  // namespace analogon
namespace analogon::ui {

/// The experiments with their files, and which column each model input and output is taken from.
class MeasurementPanel : public QWidget {
    Q_OBJECT

public:
    explicit MeasurementPanel(Document& document, QWidget* parent = nullptr);

    QTreeWidget* tree() const { return tree_; }
    /// Shows a file as it will be read; it becomes an experiment when the user accepts it.
    void import(const QString& path) { Q_EMIT importWanted(path); }
    /// Maps what has no column yet.
    void propose();
    /// The row of a signal of an experiment, to point at it; null: none.
    QTreeWidgetItem* signalItem(const QString& experiment, const QString& signal) const;

    /// Whether the input of a row keeps each value until its next sample, or runs on straight lines between them.
    void holdInput(const QTreeWidgetItem* item, bool isHeld);

Q_SIGNALS:
    void experimentChosen(const QString& name);
    void importWanted(const QString& path);
    void browseWanted();
    void valuesWanted(const QString& experiment);
    void locateWanted(const QString& experiment);
    void tableWanted();
    void comparisonWanted(const QString& signal, const QString& experiment);
    /// The declaration of a source that repeats a recorded channel, without a place in the diagram.
    void sourceMade(const QString& declaration);
    void told(const QString& sentence);  // why something was not done

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    friend class MappingDelegate;
    enum class Kind { Experiment, Info, Unread, Input, Output, Spare, Range };
    enum TreeColumn { Model, Source, Clock, Unit, ColumnCount };
    /// What the rows of a recording are made from.
    struct RowContent {
        StudyExperiment recording;
        std::shared_ptr<const Table> table;
        QStringList faults;  // why it was not read

        friend bool operator==(const RowContent&, const RowContent&) = default;
    };
    void refresh();
    void fillTree();
    std::vector<RowContent> contents() const;
    void replaceRows(std::size_t first, std::size_t last, const std::vector<RowContent>& now);
    void unfold(QTreeWidgetItem* top, bool isUnfolded);
    static QString unmappedText(const StudyExperiment& experiment, const SignalFact& fact, bool isInput,
                                const Table* table);
    QTreeWidgetItem* itemOf(const RowContent& content);
    void markLeftOut();
    void mark(QTreeWidgetItem* top, const StudyExperiment& experiment) const;
    void addUnread(QTreeWidgetItem* top, const QStringList& faults);
    void addSpares(QTreeWidgetItem* top, const Table& file, const std::set<QString>& used);
    void measureExtents();
    bool isExtentAtHand(const StudyExperiment& experiment) const;
    static void showExtent(QTreeWidgetItem* info, const RecordingExtent& extent);
    QTreeWidgetItem* addRow(QTreeWidgetItem* top, Kind kind, const QString& text, const QString& value);
    void map(const QTreeWidgetItem* item, const QString& column);
    void setRole(const QTreeWidgetItem* item, bool isFit);
    void setUsed(const QTreeWidgetItem* item, bool isUsed);
    void setRange(const QTreeWidgetItem* item, const QString& text);
    /// "fit", seconds, or a number with a unit of time; what is none of these changes nothing.
    void setClock(const QTreeWidgetItem* item, const QString& typed);
    /// In which the column of a row is written; a unit that is not known, or is none of the model's, is refused.
    void setUnit(const QTreeWidgetItem* item, const QString& typed);
    std::string unitInFile(const QTreeWidgetItem* item) const;
    std::string unitInModel(const QTreeWidgetItem* item) const;
    QStringList unitsFor(const QTreeWidgetItem* item) const;
    void addInterpolation(QMenu& menu, const QTreeWidgetItem* item);
    void addSource(QMenu& menu, const QTreeWidgetItem* item);
    void makeSource(const StudyExperiment& experiment, const ChannelMapping& mapping, const std::string& unit);
    QString whyNoneIsProposed(const std::vector<StudyExperiment>& proposed) const;
    void removeExperiment();
    void showMenu(QPoint at);
    void showValuesOf(const QTreeWidgetItem* item);
    const StudyExperiment* experimentOf(const QTreeWidgetItem* item) const;
    const ChannelMapping* mappingOf(const QTreeWidgetItem* item) const;
    void change(const QTreeWidgetItem* item, const QString& what, const std::function<void(StudyExperiment&)>& edit);

    Document& document_;
    JobRunner measurer_, sourceMaker_;
    QTreeWidget* tree_;
    QStackedLayout* pages_;
    QLabel* empty_;
    QToolButton *import_, *propose_, *table_;
    QString draggedColumn_;  // under way to a signal; empty: none
    QPoint pressedAt_;
    bool isDragging_{};
    bool isMeasureOwed_{};                                // something changed while nobody saw the panel
    std::vector<RowContent> shown_;                       // of each row of the tree
    std::vector<SignalFact> shownInputs_, shownOutputs_;  // of the model they were made for
};

}  // namespace analogon::ui
