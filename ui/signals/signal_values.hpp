#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "core/study/sensitivity.hpp"
#include "ui/job/job.hpp"
#include "ui/plot/series.hpp"
#include "ui/signals/signal_list.hpp"

namespace analogon::ui {

class Document;

/// A signal with its numbers, or why it has none.
struct SignalData {
    std::shared_ptr<const std::vector<double>> time;  // [s]; null: there are none
    Series values;                                    // one per time stamp; NaN: none
    QString unit;
    QString fault;

    static SignalData failed(const Diagnostic& fault);
};

/// The numbers of signals, fetched when they are asked for and not on the thread of the window: what was recorded at
/// once, before anything is simulated; variables of the model by a simulation of the study as it stands, those of one
/// recording together; formulas when all that they use is there; sensitivities of all outputs to all parameters by one
/// simulation, at the fitted values where a fit is shown.
class SignalValues : public QObject {
    Q_OBJECT

public:
    explicit SignalValues(Document& document, QObject* parent = nullptr);

    /// Null: they are on their way, arrived() tells.
    std::shared_ptr<const SignalData> at(const SignalRef& reference);
    bool isSimulating() const { return simulator_.isBusy(); }
    /// How often the model was simulated for this.
    int simulations() const { return simulations_; }

Q_SIGNALS:
    void arrived();
    /// What was given before is that of another study: ask again.
    void outdated();

private:
    using Data = std::shared_ptr<const SignalData>;
    void keep(const SignalRef& reference, SignalData data);
    void forget(const std::function<bool(SignalKind)>& isOld);
    void work();
    void startReading();
    void startSimulation();
    void startSensitivities();
    std::optional<SignalData> residual(const SignalRef& reference) const;
    /// What a formula calls by a name: a variable of the model, else a channel.
    SignalRef meant(const QString& name, const QString& recording) const;
    std::optional<std::function<SignalData()>> derivation(const SignalRef& reference);

    Document& document_;
    std::map<QString, Data> known_;
    std::vector<SignalRef> wanted_;                   // channels, formulas
    std::map<QString, std::set<QString>> variables_;  // wanted ones by recording
    std::vector<SignalRef> sensitivities_;            // wanted ones
    std::set<QString> underWay_;                      // keys of all that is wanted or worked on
    JobRunner reader_, simulator_, differentiator_;
    std::shared_ptr<const Outcome<Sensitivity>> slopes_;  // of the study as it stands; null: not asked for yet
    int simulations_{};
};

}  // namespace analogon::ui
