#pragma once

#include <QString>
#include <vector>

class QJsonObject;

namespace analogon::ui {

class Document;

enum class SignalKind { Recorded, Variable, Residual, Derived, Sensitivity };

/// Which signal is meant, and of which recording: a channel of it, a variable of the model simulated over it, what is
/// left of an output, a formula over others, or how far an output moves with a parameter.
struct SignalRef {
    SignalKind kind{SignalKind::Recorded};
    QString recording;
    QString name;  // of the channel, the variable, the output; the formula; or by sensitivityName()

    /// Tells it from all others.
    QString key() const;
    QJsonObject json() const;
    /// Of a text that nobody has looked at: nameless where it makes no sense.
    static SignalRef of(const QJsonObject& json);
    friend bool operator==(const SignalRef&, const SignalRef&) = default;
};

/// "∂y/∂ln R": the slope of an output over a parameter times the value of the parameter, in the unit of the output.
QString sensitivityName(const std::string& output, const std::string& parameter);
/// The output of a name like that; empty: it is none.
QString sensitiveOutput(const QString& name);

/// Signals as they go from one panel to another with the mouse.
inline constexpr const char* signalMime = "application/x-analogon-signals";
QByteArray mimeOf(const std::vector<SignalRef>& references);
std::vector<SignalRef> signalsOf(const QByteArray& mime);

/// A signal as it is listed. A variable of the model has no recording of its own.
struct Signal {
    SignalRef reference;
    QString group;  // the recording, or the component
    QString unit, description;
    QString words;  // all of it in small letters, for the search
};

/// Every signal of the study: channels of the recordings, mapped or not, formulas, residuals of the outputs, how far
/// the outputs of each fitted recording move with each fitted parameter, variables of the model by component. Of one
/// group they stand together.
std::vector<Signal> allSignals(const Document& document, const std::vector<QString>& formulas);

/// Those in which each word of the query stands somewhere: in name, unit, description, recording or component.
std::vector<int> matching(const std::vector<Signal>& all, const QString& query);

}  // namespace analogon::ui
