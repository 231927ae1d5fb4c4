#pragma once

#include <functional>

class QLineEdit;
class QWidget;

namespace analogon::ui::style {

/// Ctrl+F, wherever in a panel the keys go, leads to its search field, with what it holds marked. `field` gives null
/// while the panel shows none.
void findBy(QWidget& panel, std::function<QLineEdit*()> field);

}  // namespace analogon::ui::style
