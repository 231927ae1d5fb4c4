#include "ui/style/find_key.hpp"

#include <QLineEdit>
#include <QShortcut>

namespace analogon::ui::style {

void findBy(QWidget& panel, std::function<QLineEdit*()> field) {
    auto* key = new QShortcut(QKeySequence::Find, &panel);
    key->setContext(Qt::WidgetWithChildrenShortcut);
    QObject::connect(key, &QShortcut::activated, &panel, [field = std::move(field)] {
        QLineEdit* const search = field();
        if (!search || !search->isVisible()) return;
        search->setFocus(Qt::ShortcutFocusReason);
        search->selectAll();
    });
}

}  // namespace analogon::ui::style
