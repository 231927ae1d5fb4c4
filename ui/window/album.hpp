#pragma once

#include <QDir>
#include <QSize>
#include <QString>
#include <functional>

class QWidget;

namespace analogon::ui {

class MainWindow;

/// The pictures of one pass through the work, in one look and language.
class Album {
public:
    /// `data`: where the windows of the program keep what is theirs meanwhile.
    Album(const QDir& directory, QString suffix, const QDir& data)
        : directory_(directory), suffix_(std::move(suffix)), data_(data) {}

    /// Before a window opens a study: the work that an earlier one of the album has left unsaved is not offered.
    void beginAnew();

    void take(MainWindow& window, const QString& name);
    /// Of a window of its own over it.
    void takeDialog(QWidget& dialog, const QString& name);
    /// What a picture shows must hold, else the album is not whole.
    void expect(bool holds) { isWhole_ = isWhole_ && holds; }
    bool isWhole() const { return isWhole_; }

private:
    QDir directory_;
    QString suffix_;
    QDir data_;
    int windows_{};
    bool isWhole_{true};
};

/// Lets the program go on until it holds; false: it has taken too long.
bool waitUntil(const std::function<bool()>& holds, int milliseconds = 900000);
void goOnFor(int milliseconds = 120);

/// False: the study did not come up, or its start values gave no trace.
bool openIn(Album& album, MainWindow& window, QSize size, const QString& example);

// Scenes of it, each with a window of its own. False: something that they show did not come about.
bool takeGroup(Album& album, const QString& example);
bool takeSmall(Album& album, const QString& example);
/// A block of the library with what it is for, and a wire on its way to a connector that does not fit.
bool takeComposing(Album& album, const QString& example);
/// A block by another word for it, a search without result, and a word of the text.
bool takeFinding(Album& album, const QString& example);
/// A fit on its way, and a value that it would like beyond its bound.
bool takeRunning(Album& album, const QString& example);
/// Signals of every kind, with two cursors.
bool takeSignals(Album& album, const QString& example);
/// The arrangement for each part of the work, with a parameter that is turned; the result with its runs named.
bool takeArrangements(Album& album, const QString& example);
/// The error over one parameter, and over two.
bool takeSweep(Album& album, const QString& example);
/// The head of the report, and what is found in the study.
bool takeDialogs(Album& album, const QString& example);

}  // namespace analogon::ui
