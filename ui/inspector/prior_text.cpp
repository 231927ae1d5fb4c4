#include "ui/inspector/prior_text.hpp"

#include <QRegularExpression>
#include <QStringList>

#include "ui/style/number.hpp"

namespace analogon::ui {

QString priorText(const NormalPrior& prior, int digits) {
    return QStringLiteral("%1 ± %2").arg(style::numberText(prior.mean, digits),
                                         style::numberText(prior.deviation, digits));
}

std::optional<NormalPrior> readPrior(const QString& typed) {
    // Not every keyboard has the sign.
    static const QRegularExpression between(QStringLiteral(R"(\s*(?:±|\+/?-|;)\s*|\s+)"));
    const QStringList parts = typed.trimmed().split(between, Qt::SkipEmptyParts);
    if (parts.size() != 2) return std::nullopt;
    const std::optional<double> mean = style::readNumber(parts[0]), deviation = style::readNumber(parts[1]);
    return mean && deviation && *deviation > 0 ? std::optional(NormalPrior{*mean, *deviation}) : std::nullopt;
}

}  // namespace analogon::ui
