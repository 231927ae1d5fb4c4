#pragma once

#include <QWidget>
#include <set>
#include <string>

class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace analogon::ui {

class Document;
class RecordingsModel;

/// The recordings of the study as a table that sorts, in which role and weight are edited; runs on the marked rows
/// alone.
class RecordingsPage : public QWidget {
    Q_OBJECT

public:
    explicit RecordingsPage(Document& document, QWidget* parent = nullptr);

    RecordingsModel* model() const { return model_; }
    QTableView* view() const { return view_; }
    QLineEdit* filterField() const { return filter_; }
    QPushButton* fitButton() const { return fit_; }
    QPushButton* searchButton() const { return search_; }
    QPushButton* closeButton() const { return close_; }
    std::set<std::string> marked() const;
    /// No run can begin while another is under way.
    void setRunning(bool isRunning);
    void focusTable();

Q_SIGNALS:
    void left();
    void fitWanted(const std::set<std::string>& recordings);
    void searchWanted(const std::set<std::string>& recordings);
    void valuesWanted(const QString& experiment);
    void locateWanted(const QString& experiment);
    void experimentChosen(const QString& experiment);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    QLayout* buttons();
    void fitNames();
    void updateState();
    void toggleUsed();
    void showMenu(QPoint at);
    void addEdits(QMenu& menu);
    QString current() const;

    RecordingsModel* model_;
    QSortFilterProxyModel* sorted_;
    QTableView* view_;
    QLineEdit* filter_;
    QLabel* caption_;
    QPushButton *fit_, *search_, *close_;
    bool isRunning_{};
};

}  // namespace analogon::ui
