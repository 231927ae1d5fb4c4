#pragma once

#include <QAbstractTableModel>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/fit/fit.hpp"
#include "core/study/study.hpp"
#include "ui/job/job.hpp"
#include "ui/measurement/recording_extent.hpp"

namespace analogon::ui {

class Document;

/// The recordings of the study with what is settled of each and what the present run says of it. Every edit goes
/// through the document and is one step of undo. As long as nobody sees it, it does nothing and stays as it was.
class RecordingsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    /// Behind these one column for each output, then samples, duration and fault.
    enum Column { Name, File, Role, Weight, FirstError };
    /// SortRole: what a column is sorted by. NameRole: of the recording, in any column.
    enum DataRole { SortRole = Qt::UserRole, NameRole };

    explicit RecordingsModel(Document& document, QObject* parent = nullptr);

    /// Whether somebody sees it: it then follows the document, at once where that has changed meanwhile.
    void setShown(bool isShown);

    int samplesColumn() const { return FirstError + static_cast<int>(outputs_.size()); }
    int durationColumn() const { return samplesColumn() + 1; }
    int faultColumn() const { return samplesColumn() + 2; }
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    /// Of several recordings at once, as one step of undo.
    void setUsed(const std::set<std::string>& recordings, bool isUsed);
    void setRole(const std::set<std::string>& recordings, analogon::Role role);
    void setWeight(const std::set<std::string>& recordings, double weight);
    bool isUsed(const std::string& recording) const;
    /// Which of them a run on these alone would use, and whether there is anything to fit among them.
    std::set<std::string> usable(const std::set<std::string>& recordings) const;
    bool hasFitted(const std::set<std::string>& recordings) const;

    /// A weight as it is typed; none: it cannot be one.
    static std::optional<double> readWeight(const QString& typed);

private:
    struct Error {
        std::optional<ErrorFigures> before, after;
        std::string unit;
    };
    struct Row {
        std::string name, path;
        QString file;
        bool isUsed{}, isFit{}, isMissing{};
        std::optional<std::pair<double, double>> weights;  // least and most of its outputs; none: it has no output
        std::optional<RecordingExtent> extent;
        std::map<std::string, Error> errors;
        QStringList fault;
        QString failure;  // of its simulation
    };
    void follow();
    void refresh();
    Row rowOf(const StudyExperiment& experiment) const;
    void readErrors(std::vector<Row>& rows) const;
    void measureExtents();
    std::string extentKey(const StudyExperiment& experiment) const;
    QVariant display(const Row& row, int column) const;
    QString errorOfColumn(const Row& row, int column) const;
    QVariant sortKey(const Row& row, int column) const;
    QVariant tooltip(const Row& row, int column) const;
    const Error* errorOf(const Row& row, int column) const;

    Document& document_;
    JobRunner measurer_;
    std::vector<Row> rows_;
    std::vector<std::string> outputs_;
    std::map<std::string, RecordingExtent> extents_;  // those that were worked out, by what they depend on
    bool isShown_{}, isBehind_{true};                 // behind what the document says
};

}  // namespace analogon::ui
