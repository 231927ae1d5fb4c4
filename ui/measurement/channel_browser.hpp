#pragma once

#include <QWidget>
#include <memory>
#include <set>
#include <string>

#include "core/measure/recording.hpp"
#include "ui/job/job.hpp"

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace analogon::ui {

class ChannelSketch;

/// The channels of a file that has many, before any is read: searched by name, unit and comment, and chosen.
class ChannelBrowser : public QWidget {
    Q_OBJECT

public:
    explicit ChannelBrowser(QWidget* parent = nullptr);

    void show(std::shared_ptr<const MeasurementFile> file);
    /// The names of the channels that are ticked.
    std::set<std::string> chosen() const;
    QLineEdit* searchField() const { return search_; }
    QTreeWidget* tree() const { return tree_; }
    QPushButton* readButton() const { return read_; }
    QPushButton* tickButton() const { return tick_; }
    ChannelSketch* sketch() const { return sketch_; }

Q_SIGNALS:
    void readWanted();

private:
    void fill();
    void filter(const QString& words);
    /// Ticks what the search shows.
    void tickShown();
    void count();
    void draw(const QTreeWidgetItem* item);

    std::shared_ptr<const MeasurementFile> file_;
    JobRunner drawer_;
    bool isCounting_{};
    QLineEdit* search_;
    QTreeWidget* tree_;
    ChannelSketch* sketch_;
    QLabel* about_;
    QPushButton *tick_, *read_;
};

}  // namespace analogon::ui
