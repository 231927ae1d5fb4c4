#include "ui/inspector/prior_text.hpp"

#include <QLocale>
#include <QRegularExpression>
#include <QStringList>
#include <cmath>

#include "ui/style/style.hpp"

namespace analogon::ui {

QString priorText(const NormalPrior& prior, int digits) {
    return QStringLiteral("%1 ± %2").arg(style::numberText(prior.mean, digits),
                                         style::numberText(prior.deviation, digits));
}

std::optional<NormalPrior> readPrior(const QString& typed) {
    // Not every keyboard has the sign.
    static const QRegularExpression between(QStringLiteral(R"(\s*(?:±|\+/?-|;)\s*|\s+)"));
    const QStringList parts = QString(typed).trimmed().replace(',', '.').split(between, Qt::SkipEmptyParts);
    if (parts.size() != 2) return std::nullopt;
    bool isMean = false, isDeviation = false;
    const NormalPrior prior{QLocale::c().toDouble(parts[0], &isMean), QLocale::c().toDouble(parts[1], &isDeviation)};
    const bool isPrior = isMean && isDeviation && std::isfinite(prior.mean) && std::isfinite(prior.deviation);
    return isPrior && prior.deviation > 0 ? std::optional(prior) : std::nullopt;
}

}  // namespace analogon::ui
