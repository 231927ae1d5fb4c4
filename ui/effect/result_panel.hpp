#pragma once

#include <QScrollArea>
#include <QTimer>

#include "core/effect/tell/preview.hpp"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;
class QVBoxLayout;

namespace analogon {
struct AddedEffect;
struct CandidateResult;
struct Finding;
struct Remainder;
enum class Verdict;
}  // namespace analogon

namespace analogon::ui {

class Document;
struct Mention;

/// What the last run came to, in the order of the questions: what was found, how much better it is, on what
/// evidence, and what else was tried.
class ResultPanel : public QScrollArea {
    Q_OBJECT

public:
    explicit ResultPanel(Document& document, QWidget* parent = nullptr);

    QString headline() const;
    /// Of a row of the candidates; the first is the kind, the place to point at, the class and the place, from the
    /// left. FigureRole: what a column is sorted by, where that is a number.
    enum CandidateRole { KindRole = Qt::UserRole, RoundRole, RankRole, FigureRole };
    QTreeWidget* candidates() const { return candidates_; }  // null: none
    QTreeWidget* comparison() const { return comparison_; }
    QPushButton* longerButton() const { return longer_; }   // null: the search was not ended at its limit of work
    QPushButton* tryButton() const { return try_; }         // null: no candidates
    QLineEdit* candidateFilter() const { return filter_; }  // the same
    QCheckBox* roundBox() const { return byRound_; }        // the same

Q_SIGNALS:
    void effectChosen(const QString& instance);
    void placePointedAt(const QString& place);  // a block or connector of the diagram; empty: none
    /// What the traces would be with this effect is to be shown, until effectLeft().
    void effectLookedAt(const analogon::EffectChoice& choice, const QString& name);
    void effectLeft();
    void trialWanted(const analogon::EffectChoice& choice);
    void longerSearchWanted();
    /// Something that a sentence speaks of.
    void mentionChosen(const analogon::ui::Mention& mention);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();
    void lookAt(const QTreeWidgetItem* candidate);
    void addEmptyState();
    void addHeadline(const Finding& finding);
    void addAdoption();
    void addComparison(const Finding& finding);
    void addEffect(const AddedEffect& effect, bool isOneOfSeveral);
    void addRemainder(const Finding& finding);
    void addProposalAdoption(const Finding& finding);
    void addCautions(const Finding& finding);
    void addCandidates(const Finding& finding);
    QTreeWidgetItem* addCandidate(const CandidateResult& candidate);
    void addCandidateTools();
    void groupCandidates();
    void sortBy(int column);
    void filterCandidates();
    void giveNamesRoom();
    void tryCandidate(const QTreeWidgetItem* item);
    void addButton(QPushButton* button);
    QLabel* addText(const QString& text, bool isCaption = false);
    /// What of the study is named in it leads there.
    void makeLinks(QLabel* label, const QString& html);
    void addHeading(const QString& text);

    Document& document_;
    QTimer soon_;
    QWidget* body_{};
    QVBoxLayout* column_{};
    QLabel* headline_{};
    QTreeWidget* candidates_{};
    QTreeWidget* comparison_{};
    QPushButton *try_{}, *longer_{};
    QLineEdit* filter_{};
    QCheckBox* byRound_{};
    QString sought_;  // what of the candidates is shown, and how: it stays when the page is built anew
    bool isByRound_{};
    int sortedBy_{-1};  // column; -1: as they were tried
    Qt::SortOrder order_{Qt::AscendingOrder};
};

}  // namespace analogon::ui
