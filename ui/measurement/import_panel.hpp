#pragma once

#include <QWidget>
#include <set>

#include "core/study/study.hpp"
#include "ui/job/job.hpp"
#include "ui/measurement/table_model.hpp"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QStackedLayout;
class QTableView;

namespace analogon {
struct MeasurementFile;
}
namespace analogon::ui {

class ChannelBrowser;
class Document;

/// A measurement file before it becomes part of the study: how it is read, what is in it, what is wrong with it.
class ImportPanel : public QWidget {
    Q_OBJECT

public:
    explicit ImportPanel(Document& document, QWidget* parent = nullptr);

    void show(const QString& path);
    QPushButton* acceptButton() const { return accept_; }
    QComboBox* timeBox() const { return time_; }
    TableModel* model() const { return model_; }
    ChannelBrowser* browser() const { return browser_; }
    QCheckBox* convertedBox() const { return converted_; }
    QString problems() const;
    /// Shows a line of the file, once it has been read.
    void pointAt(int line);

Q_SIGNALS:
    void accepted(const QString& experiment);
    void cancelled();

private:
    void read();
    void readValues();
    void connectReading();
    void browse();
    /// What a file that is no text holds; null: it is a text, or cannot be read, which the reading of its values tells.
    struct Listing {
        std::shared_ptr<const MeasurementFile> file{};

        static Listing failed(const Diagnostic&) { return {}; }
    };
    /// What was read: the table, or the lines of a file that is none.
    struct Preview {
        Outcome<std::shared_ptr<const Table>> table;  // on one raster
        std::vector<FileLine> lines;
        std::shared_ptr<const Table> file{};
        ReadOptions options{};

        static Preview failed(const Diagnostic& fault) { return {fault, {}}; }
    };
    void showPreview(Preview preview);
    void tellProblems(const Diagnostics& problems);
    void accept();
    QString freeName() const;

    Document& document_;
    QString path_;
    std::shared_ptr<const Table> table_, file_;  // as it is shown, and whole
    ReadOptions options_;
    QString told_;                  // what is wrong, as plain text
    std::set<std::string> chosen_;  // channels that are read; empty: all
    std::size_t channels_{};        // of the file
    int wantedLine_{};              // to be shown once it is there; 0: none
    JobRunner reader_;
    TableModel* model_;
    QLabel *title_, *problems_;
    QLineEdit* name_;
    QComboBox *separator_, *decimal_, *units_, *time_, *role_;
    QCheckBox* converted_;
    QTableView* view_;
    ChannelBrowser* browser_;
    QProgressBar* progress_;
    QPushButton *choose_, *accept_, *cancel_;
    QStackedLayout* pages_{};
};

}  // namespace analogon::ui
