#pragma once

#include <QWidget>
#include <set>

#include "core/measure/text/question_rows.hpp"
#include "core/study/study.hpp"
#include "ui/job/job.hpp"
#include "ui/measurement/table_model.hpp"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QStackedLayout;
class QTableView;

namespace analogon {
struct MeasurementFile;
}
namespace analogon::ui {

class ChannelBrowser;
class Document;
class QuestionCard;
class ReadFields;

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
    ReadFields* fields() const { return fields_; }
    QuestionCard* question() const { return question_; }
    QCheckBox* convertedBox() const { return converted_; }
    QString problems() const;
    /// Shows a line of the file, once it has been read.
    void pointAt(int line);

Q_SIGNALS:
    void accepted(const QString& experiment);
    void cancelled();

private:
    void layOut();
    void connectFields();
    void connectReading();
    void read();
    void readValues();
    void readText();
    /// Of a text that was read: the channels that were chosen.
    void takeChosen();
    void browse();
    /// The table, or the channels to choose from.
    void showPage(QWidget* page);
    /// What was read: the table, or the lines of a file that is none.
    struct Preview {
        Outcome<std::shared_ptr<const Table>> table;  // on one raster
        std::vector<FileLine> lines{};
        std::shared_ptr<const Table> file{};
        ReadOptions options{};
        std::shared_ptr<const MeasurementFile> recording{};  // of a text, what it holds
        Diagnostics told{};                                  // about the whole of it
        Questions asked{};
        QuestionRows rows{};  // of the first question
        std::string time{};   // the column that is time; empty: none is by its name or unit

        static Preview failed(const Diagnostic& fault) { return {fault}; }
    };
    static Preview previewOfText(const std::string& path, const ReadOptions& options,
                                 const std::set<std::string>& chosen, const Progress& progress);
    static Preview previewOf(const std::string& path, const ReadOptions& options, const std::set<std::string>& chosen,
                             const Progress& progress);
    static Outcome<std::shared_ptr<const Table>> onOneRaster(const std::shared_ptr<const Table>& file,
                                                             const std::set<std::string>& chosen,
                                                             const Diagnostics& told);
    /// What a file is, and what it holds; without a recording it has few channels, which are read.
    struct Look {
        bool isText{};
        std::shared_ptr<const MeasurementFile> recording{};
        Preview preview;

        static Look failed(const Diagnostic& fault) { return {false, nullptr, Preview::failed(fault)}; }
    };
    void showLook(Look look);
    void showPreview(Preview preview);
    /// With what else is found out beside the window.
    static Preview complete(Preview preview);
    void showTimes(const std::string& proposed);
    void ask(const Preview& preview);
    void takeAnswer(const ReadOptions& options);
    void tellProblems(const Diagnostics& problems);
    void tellRates();
    void allowAccept();
    void accept();
    QString freeName() const;

    Document& document_;
    QString path_;
    std::shared_ptr<const Table> table_, file_;  // as it is shown, and whole
    ReadOptions options_;
    QString told_;                                      // what is wrong, as plain text
    std::set<std::string> chosen_;                      // channels that are read; empty: all
    std::shared_ptr<const MeasurementFile> recording_;  // of a text, what it holds
    Diagnostics whole_;                                 // what is told about the whole of it
    bool isText_{};
    int wantedLine_{};  // to be shown once it is there; 0: none
    JobRunner reader_;
    TableModel* model_;
    QLabel *title_, *problems_;
    QLineEdit* name_;
    QComboBox *time_, *role_;
    ReadFields* fields_;
    QuestionCard* question_;
    QCheckBox* converted_;
    QTableView* view_;
    ChannelBrowser* browser_;
    QProgressBar* progress_;
    QPushButton *choose_, *accept_, *cancel_;
    QScrollArea* scroll_;
    QStackedLayout* pages_{};
    QWidget* shown_{};  // the pages
};

}  // namespace analogon::ui
