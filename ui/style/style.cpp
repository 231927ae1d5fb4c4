#include "ui/style/style.hpp"

#include <QAbstractItemView>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QProgressBar>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <QStyledItemDelegate>
#include <QTabBar>
#include <QTreeView>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/style/breakable.hpp"
#include "ui/style/tab_room.hpp"
#include "ui/style/tinted_icon.hpp"
#include "ui/style/wheel_guard.hpp"

// Resources of a static library must be asked for; the macro wants the global namespace.
static void loadIcons() { Q_INIT_RESOURCE(icons); }

namespace analogon::ui::style {

namespace {

Theme chosen = Theme::System;  // the program's one look, set by apply()

QPalette lightPalette() {
    QPalette p;
    const QColor text(0x1d, 0x24, 0x2e), muted(0x9a, 0xa3, 0xae);
    p.setColor(QPalette::Window, QColor(0xf3, 0xf4, 0xf6));
    p.setColor(QPalette::WindowText, text);
    p.setColor(QPalette::Base, QColor(0xff, 0xff, 0xff));
    p.setColor(QPalette::AlternateBase, QColor(0xf8, 0xf9, 0xfa));
    p.setColor(QPalette::Text, text);
    p.setColor(QPalette::PlaceholderText, QColor(0x67, 0x71, 0x7d));
    p.setColor(QPalette::Button, QColor(0xf7, 0xf8, 0xf9));
    p.setColor(QPalette::ButtonText, text);
    p.setColor(QPalette::BrightText, Qt::white);
    p.setColor(QPalette::ToolTipBase, QColor(0x2a, 0x31, 0x3c));
    p.setColor(QPalette::ToolTipText, QColor(0xf3, 0xf4, 0xf6));
    p.setColor(QPalette::Highlight, QColor(0x1f, 0x6f, 0xc4));
    p.setColor(QPalette::HighlightedText, Qt::white);
    p.setColor(QPalette::Link, QColor(0x1f, 0x6f, 0xc4));
    p.setColor(QPalette::Light, Qt::white);
    p.setColor(QPalette::Midlight, QColor(0xe9, 0xeb, 0xee));
    p.setColor(QPalette::Mid, QColor(0xcf, 0xd4, 0xda));
    p.setColor(QPalette::Dark, QColor(0xa8, 0xb0, 0xba));
    p.setColor(QPalette::Shadow, QColor(0x6d, 0x76, 0x82));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, muted);
    p.setColor(QPalette::Disabled, QPalette::Highlight, QColor(0xcf, 0xd4, 0xda));
    return p;
}

QPalette darkPalette() {
    QPalette p;
    const QColor text(0xe2, 0xe6, 0xeb), muted(0x6c, 0x76, 0x82);
    p.setColor(QPalette::Window, QColor(0x20, 0x24, 0x2a));
    p.setColor(QPalette::WindowText, text);
    p.setColor(QPalette::Base, QColor(0x18, 0x1b, 0x20));
    p.setColor(QPalette::AlternateBase, QColor(0x1d, 0x21, 0x26));
    p.setColor(QPalette::Text, text);
    p.setColor(QPalette::PlaceholderText, QColor(0x93, 0x9d, 0xa9));
    p.setColor(QPalette::Button, QColor(0x2a, 0x2f, 0x36));
    p.setColor(QPalette::ButtonText, text);
    p.setColor(QPalette::BrightText, Qt::white);
    p.setColor(QPalette::ToolTipBase, QColor(0x3a, 0x41, 0x4b));
    p.setColor(QPalette::ToolTipText, text);
    p.setColor(QPalette::Highlight, QColor(0x2a, 0x73, 0xc2));
    p.setColor(QPalette::HighlightedText, Qt::white);
    p.setColor(QPalette::Link, QColor(0x6a, 0xad, 0xf0));
    p.setColor(QPalette::Light, QColor(0x3a, 0x41, 0x4a));
    p.setColor(QPalette::Midlight, QColor(0x30, 0x36, 0x3e));
    p.setColor(QPalette::Mid, QColor(0x3a, 0x41, 0x4a));
    p.setColor(QPalette::Dark, QColor(0x12, 0x15, 0x19));
    p.setColor(QPalette::Shadow, QColor(0x0a, 0x0c, 0x0e));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, muted);
    p.setColor(QPalette::Disabled, QPalette::Highlight, QColor(0x3a, 0x41, 0x4a));
    return p;
}

/// Fusion without its gradients: flat bars, tabs and headers, rows with air between them, and check marks that can be
/// seen on a dark ground.
class Flat : public QProxyStyle {
public:
    Flat() : QProxyStyle(QStyleFactory::create("Fusion")) {}

    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
        switch (metric) {
            case PM_ScrollBarExtent:
                return 3 * unit;
            case PM_HeaderMargin:  // as the text of the cells below
                return unit;
            case PM_TabBarTabShiftVertical:
                return 0;
            case PM_TabBarTabHSpace:  // in a small window the words of the tabs need the room
                return widget && isNarrowWindow(*widget->window()) ? 2 * unit : 6 * unit;
            case PM_FocusFrameHMargin:  // beside the text of a cell
                return unit - 1;
            case PM_DockWidgetSeparatorExtent:
                return unit + 1;
            case PM_DefaultFrameWidth:  // the line and a pixel of air, which it may round into between whole scales
                return widget && widget->inherits("QAbstractItemView")
                           ? 2
                           : QProxyStyle::pixelMetric(metric, option, widget);
            default:
                return QProxyStyle::pixelMetric(metric, option, widget);
        }
    }

    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* more) const override {
        if (hint == SH_Table_GridLineColor && option) return static_cast<int>(hairline(option->palette).rgba());
        return QProxyStyle::styleHint(hint, option, widget, more);
    }

    /// Air between the frame of a field and its text.
    QRect subElementRect(SubElement element, const QStyleOption* option, const QWidget* widget) const override {
        const QRect rect = QProxyStyle::subElementRect(element, option, widget);
        const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
        if (element != SE_LineEditContents || !frame || frame->lineWidth <= 0) return rect;
        return rect.adjusted(unit - 1, 0, 1 - unit, 0);
    }

    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                           const QWidget* widget) const override {
        QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
        switch (type) {
            case CT_ItemViewItem:
                size.rheight() = std::max(size.height(), option->fontMetrics.height() + 2 * unit);
                break;
            case CT_PushButton:
                size += QSize(3 * unit, 0);
                size.rheight() = std::max(size.height(), option->fontMetrics.height() + 3 * unit);
                break;
            case CT_ComboBox:
            case CT_LineEdit:
            case CT_SpinBox:
                size.rheight() = std::max(size.height(), option->fontMetrics.height() + 3 * unit);  // as a button
                break;
            case CT_HeaderSection:
                size.rheight() = std::max(size.height(), option->fontMetrics.height() + 2 * unit);
                break;
            case CT_TabBarTab:
                size += QSize(2 * unit, unit);
                break;
            default:
                break;
        }
        return size;
    }

    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
        const QPalette& p = option->palette;
        switch (element) {
            case CE_ToolBar:
                painter->fillRect(option->rect, p.window());
                return underline(*painter, option->rect, hairline(p), 1);
            case CE_HeaderSection:
                painter->fillRect(option->rect, mix(p.color(QPalette::Base), p.color(QPalette::Window), 0.6));
                return underline(*painter, option->rect, hairline(p), 1);
            case CE_HeaderEmptyArea:
                painter->fillRect(option->rect, mix(p.color(QPalette::Base), p.color(QPalette::Window), 0.6));
                return underline(*painter, option->rect, hairline(p), 1);
            case CE_HeaderLabel: {
                auto header = *static_cast<const QStyleOptionHeader*>(option);
                header.palette.setColor(QPalette::ButtonText, mutedText(p));
                return QProxyStyle::drawControl(element, &header, painter, widget);
            }
            case CE_Splitter:
                return drawSeparator(*option, *painter);
            case CE_MenuBarEmptyArea:
                painter->fillRect(option->rect, p.window());
                return underline(*painter, option->rect, hairline(p), 1);
            case CE_MenuBarItem:
                QProxyStyle::drawControl(element, option, painter, widget);
                if (option->state & State_Sunken) return;
                underline(*painter, option->rect, p.color(QPalette::Window), 2);  // over a line of the base style
                return underline(*painter, option->rect, hairline(p), 1);
            case CE_ProgressBarGroove:
                return drawGroove(*option, *painter);
            case CE_ProgressBarContents:
                if (const auto& bar = *static_cast<const QStyleOptionProgressBar*>(option); bar.maximum > bar.minimum)
                    return drawProgress(bar, *painter);
                return QProxyStyle::drawControl(element, option, painter, widget);  // of no known end: it moves
            case CE_TabBarTabShape:
                return drawTab(*static_cast<const QStyleOptionTab*>(option), *painter, widget);
            case CE_TabBarTabLabel: {
                auto tab = *static_cast<const QStyleOptionTab*>(option);
                if (!(tab.state & State_Selected)) tab.palette.setColor(QPalette::WindowText, mutedText(p));
                return QProxyStyle::drawControl(element, &tab, painter, widget);
            }
            default:
                return QProxyStyle::drawControl(element, option, painter, widget);
        }
    }

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        const QPalette& p = option->palette;
        switch (element) {
            case PE_IndicatorItemViewItemCheck:
            case PE_IndicatorCheckBox:
                return drawCheck(*option, *painter);
            case PE_PanelButtonCommand:
                return drawButton(*option, *painter);
            case PE_FrameTabBarBase:
                return underline(*painter, option->rect, hairline(p), 1);
            case PE_FrameLineEdit:
                return drawField(*option, *painter);
            case PE_Frame:
                return drawFrame(*option, *painter);
            case PE_PanelScrollAreaCorner:
                painter->fillRect(option->rect, p.base());
                return;
            case PE_IndicatorDockWidgetResizeHandle:
                return drawSeparator(*option, *painter);
            case PE_IndicatorToolBarSeparator: {
                QStyleOption line = *option;
                line.rect.adjust(0, 2 * unit, 0, -2 * unit);
                return drawSeparator(line, *painter);
            }
            case PE_FrameFocusRect:
                return drawFocus(*option, *painter);
            default:
                return QProxyStyle::drawPrimitive(element, option, painter, widget);
        }
    }

    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override {
        if (control == CC_SpinBox)
            return drawSpinBox(*static_cast<const QStyleOptionSpinBox*>(option), *painter, widget);
        if (control != CC_ScrollBar) return QProxyStyle::drawComplexControl(control, option, painter, widget);
        const auto& bar = *static_cast<const QStyleOptionSlider*>(option);
        painter->fillRect(bar.rect, bar.palette.base());
        if (bar.maximum <= bar.minimum) return;
        QRectF handle = subControlRect(CC_ScrollBar, option, SC_ScrollBarSlider, widget);
        handle = bar.orientation == Qt::Vertical ? handle.adjusted(3, 1, -3, -1) : handle.adjusted(1, 3, -1, -3);
        const bool isActive =
            (bar.activeSubControls & SC_ScrollBarSlider) && (bar.state & (State_MouseOver | State_Sunken));
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(Qt::NoPen);
        painter->setBrush(
            mix(bar.palette.color(QPalette::Base), bar.palette.color(QPalette::Text), isActive ? 0.5 : 0.25));
        painter->drawRoundedRect(handle, 3, 3);
        painter->restore();
    }

    /// A scroll bar is its handle: no arrows.
    QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                         const QWidget* widget) const override {
        if (control != CC_ScrollBar) return QProxyStyle::subControlRect(control, option, part, widget);
        const auto& bar = *static_cast<const QStyleOptionSlider*>(option);
        const bool isUpright = bar.orientation == Qt::Vertical;
        const int length = isUpright ? bar.rect.height() : bar.rect.width();
        const int range = bar.maximum - bar.minimum;
        const int shown =
            range <= 0 ? length : static_cast<int>(static_cast<qint64>(length) * bar.pageStep / (range + bar.pageStep));
        const int handle = std::clamp(shown, std::min(length, 6 * unit), length);
        const int start =
            sliderPositionFromValue(bar.minimum, bar.maximum, bar.sliderPosition, length - handle, bar.upsideDown);
        const auto along = [&](int from, int size) {
            return visualRect(bar.direction, bar.rect,
                              isUpright ? QRect(bar.rect.left(), bar.rect.top() + from, bar.rect.width(), size)
                                        : QRect(bar.rect.left() + from, bar.rect.top(), size, bar.rect.height()));
        };
        switch (part) {
            case SC_ScrollBarSlider:
                return along(start, handle);
            case SC_ScrollBarGroove:
                return bar.rect;
            case SC_ScrollBarSubPage:
                return along(0, start);
            case SC_ScrollBarAddPage:
                return along(start + handle, length - start - handle);
            default:
                return {};
        }
    }

    /// Sharp at every scale, in a colour of ours.
    QIcon standardIcon(StandardPixmap standard, const QStyleOption* option, const QWidget* widget) const override {
        if (standard == SP_LineEditClearButton) return icon("close");
        return QProxyStyle::standardIcon(standard, option, widget);
    }

private:
    static void underline(QPainter& painter, const QRect& rect, const QColor& colour, int width) {
        painter.fillRect(QRect(rect.left(), rect.bottom() - width + 1, rect.width(), width), colour);
    }

    static void drawSeparator(const QStyleOption& option, QPainter& painter) {
        const bool isUpright = option.rect.height() > option.rect.width();
        const QPoint middle = option.rect.center();
        painter.fillRect(isUpright ? QRect(middle.x(), option.rect.top(), 1, option.rect.height())
                                   : QRect(option.rect.left(), middle.y(), option.rect.width(), 1),
                         option.state & State_MouseOver ? accent(option.palette) : hairline(option.palette));
    }

    static void fillRounded(QPainter& painter, const QRectF& rect, const QColor& colour) {
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawRoundedRect(rect, 3, 3);
        painter.restore();
    }

    static void drawGroove(const QStyleOption& bar, QPainter& painter) {
        fillRounded(painter, bar.rect, hairline(bar.palette));
    }

    static void drawProgress(const QStyleOptionProgressBar& bar, QPainter& painter) {
        const double share = static_cast<double>(bar.progress - bar.minimum) / (bar.maximum - bar.minimum);
        QRectF done = bar.rect;
        done.setWidth(std::clamp(share, 0.0, 1.0) * done.width());
        painter.save();
        painter.setClipRect(done);  // its end is round where the groove is
        fillRounded(painter, bar.rect, accent(bar.palette));
        painter.restore();
    }

    /// As the base style does, only where the keyboard leads.
    static void drawFocus(const QStyleOption& focus, QPainter& painter) {
        if (!(focus.state & State_KeyboardFocusChange)) return;
        const QPalette& p = focus.palette;
        painter.save();
        painter.setPen(focus.state & State_Selected ? mix(accent(p), p.color(QPalette::HighlightedText), 0.3)
                                                    : accent(p));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(focus.rect).adjusted(0.5, 0.5, -0.5, -0.5));
        painter.restore();
    }

    static void drawTab(const QStyleOptionTab& tab, QPainter& painter, const QWidget* widget) {
        const QPalette& p = tab.palette;
        const auto* bar = qobject_cast<const QTabBar*>(widget);
        const bool hasBase = !bar || bar->drawBase();  // else a line under the others would end with the last of them
        const bool isChosen = tab.state & State_Selected;
        if (!isChosen && (tab.state & State_MouseOver) && (tab.state & State_Enabled))
            painter.fillRect(tab.rect, mix(p.color(QPalette::Window), p.color(QPalette::WindowText), 0.05));
        if (isChosen || hasBase) underline(painter, tab.rect, isChosen ? accent(p) : hairline(p), isChosen ? 2 : 1);
        if (isChosen && (tab.state & State_HasFocus))
            painter.fillRect(QRect(tab.rect.left(), tab.rect.top(), tab.rect.width(), 1), accent(p));
    }

    static void drawButton(const QStyleOption& button, QPainter& painter) {
        const QPalette& p = button.palette;
        const auto* push = qstyleoption_cast<const QStyleOptionButton*>(&button);  // null: the frame of a tool button
        const bool isEnabled = button.state & State_Enabled,
                   isDefault = push && (push->features & QStyleOptionButton::DefaultButton);
        const bool isDown = button.state & (State_Sunken | State_On), isOver = button.state & State_MouseOver;
        QColor fill = p.color(QPalette::Button),
               frame = mix(p.color(QPalette::Window), p.color(QPalette::WindowText), 0.25);
        if (isEnabled && isDefault) {
            fill = mix(fill, accent(p), 0.12);
            frame = accent(p);
        }
        if (isEnabled && (isDown || isOver)) fill = mix(fill, p.color(QPalette::ButtonText), isDown ? 0.14 : 0.06);
        if (isEnabled && (button.state & State_HasFocus)) frame = accent(p);
        if (!isEnabled) frame = hairline(p);
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(frame, 1));
        painter.setBrush(fill);
        painter.drawRoundedRect(QRectF(button.rect).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
        painter.restore();
    }

    /// A line around a field that can be seen on a dark ground too.
    static void drawField(const QStyleOption& field, QPainter& painter) {
        const QPalette& p = field.palette;
        const bool isActive = (field.state & State_HasFocus) && (field.state & State_Enabled);
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(isActive ? accent(p) : mix(p.color(QPalette::Window), p.color(QPalette::WindowText), 0.3));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(field.rect).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
        painter.restore();
    }

    /// A field with two arrows as flat as all else.
    void drawSpinBox(const QStyleOptionSpinBox& box, QPainter& painter, const QWidget* widget) const {
        const QPalette& p = box.palette;
        fillRounded(painter, QRectF(box.rect).adjusted(0.5, 0.5, -0.5, -0.5), p.color(QPalette::Base));
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        for (const bool isUp : {true, false}) {
            const SubControl part = isUp ? SC_SpinBoxUp : SC_SpinBoxDown;
            const QRectF place = subControlRect(CC_SpinBox, &box, part, widget);
            const bool isEnabled =
                (box.state & State_Enabled) &&
                (box.stepEnabled & (isUp ? QAbstractSpinBox::StepUpEnabled : QAbstractSpinBox::StepDownEnabled));
            const bool isOver = isEnabled && (box.activeSubControls & part) && (box.state & State_MouseOver);
            const QPointF middle = place.center() + QPointF(0, isUp ? 1 : -1);
            const double height = isUp ? -2 : 2;
            QPolygonF arrow{middle + QPointF(-3.5, -height), middle + QPointF(3.5, -height),
                            middle + QPointF(0, height)};
            painter.setBrush(!isEnabled ? hairline(p) : isOver ? p.color(QPalette::Text) : mutedText(p));
            painter.drawPolygon(arrow);
        }
        painter.restore();
        drawField(box, painter);
    }

    static void drawFrame(const QStyleOption& frame, QPainter& painter) {
        const QPalette& p = frame.palette;
        painter.fillRect(frame.rect, mix(p.color(QPalette::Window), p.color(QPalette::WindowText), 0.25));
        painter.fillRect(frame.rect.adjusted(1, 1, -1, -1), p.color(QPalette::Base));
    }

    static void drawCheck(const QStyleOption& option, QPainter& painter) {
        const QPalette& p = option.palette;
        const bool isOn = option.state & State_On;
        const double side = std::min({option.rect.width(), option.rect.height(), 15}) - 1.0;
        QRectF box(0, 0, side, side);
        box.moveCenter(QRectF(option.rect).center());
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        const QColor frame = option.state & State_Selected ? p.color(QPalette::Active, QPalette::HighlightedText)
                             : isOn                        ? accent(p)
                                                           : mix(p.color(QPalette::Base), p.color(QPalette::Text), 0.4);
        painter.setPen(QPen(frame, 1));
        painter.setBrush(isOn ? accent(p) : p.color(QPalette::Base));
        painter.drawRoundedRect(box, 3, 3);
        if (isOn) {
            painter.setPen(QPen(p.color(QPalette::Active, QPalette::HighlightedText), 1.7, Qt::SolidLine, Qt::RoundCap,
                                Qt::RoundJoin));
            const auto at = [&](double x, double y) { return box.topLeft() + QPointF(x * side, y * side); };
            const QPointF tick[] = {at(0.24, 0.53), at(0.43, 0.72), at(0.77, 0.31)};
            painter.drawPolyline(tick, 3);
        }
        painter.restore();
    }
};

}  // namespace

bool isDark(const QPalette& palette) { return palette.color(QPalette::Base).lightness() < 128; }

void apply(QApplication& application, Theme theme) {
    static const QPalette desktop = QGuiApplication::palette();    // before we set our own
    static WheelGuard* const guard = new WheelGuard(application);  // the application owns them
    static TabRoom* const room = new TabRoom(application);
    static_cast<void>(guard);
    static_cast<void>(room);
    loadIcons();
    chosen = theme;
    const bool dark = theme == Theme::Dark || (theme == Theme::System && isDark(desktop));
    if (!dynamic_cast<Flat*>(application.style())) QApplication::setStyle(new Flat);
    QApplication::setPalette(dark ? darkPalette() : lightPalette());
}

Theme current() { return chosen; }

QColor mix(const QColor& a, const QColor& b, double t) {
    const auto between = [t](double x, double y) { return x * (1 - t) + y * t; };
    return QColor::fromRgbF(between(a.redF(), b.redF()), between(a.greenF(), b.greenF()), between(a.blueF(), b.blueF()),
                            between(a.alphaF(), b.alphaF()));
}

QColor accent(const QPalette& palette) {
    return isDark(palette) ? QColor(0x3b, 0x88, 0xda) : palette.color(QPalette::Active, QPalette::Highlight);
}

QColor accentText(const QPalette& palette) { return palette.color(QPalette::Active, QPalette::Link); }

QColor mutedText(const QPalette& palette) {
    return mix(palette.color(QPalette::WindowText), palette.color(QPalette::Window), 0.35);
}

QColor hairline(const QPalette& palette) {
    return mix(palette.color(QPalette::Window), palette.color(QPalette::WindowText), 0.14);
}

QColor canvas(const QPalette& palette) {
    return isDark(palette) ? palette.color(QPalette::Base) : QColor(0xfd, 0xfd, 0xfe);
}

QColor good(const QPalette& palette) { return isDark(palette) ? QColor(0x5f, 0xc2, 0x8a) : QColor(0x1d, 0x7f, 0x4c); }
QColor caution(const QPalette& palette) {
    return isDark(palette) ? QColor(0xe5, 0xb0, 0x54) : QColor(0xa8, 0x66, 0x00);
}
QColor fault(const QPalette& palette) { return isDark(palette) ? QColor(0xf0, 0x7b, 0x72) : QColor(0xc0, 0x2f, 0x2a); }

QColor measuredTrace(const QPalette& palette) {
    return isDark(palette) ? QColor(0xa9, 0xb2, 0xbd) : QColor(0x79, 0x83, 0x90);
}
QColor beforeTrace(const QPalette& palette) {
    return isDark(palette) ? QColor(0xe8, 0xa0, 0x4a) : QColor(0xd9, 0x7f, 0x1c);
}
QColor afterTrace(const QPalette& palette) {
    return isDark(palette) ? QColor(0x57, 0xa6, 0xf2) : QColor(0x14, 0x62, 0xb5);
}

/// The hues of Okabe and Ito, dark enough on white and light enough on black.
QColor signalTrace(int index, const QPalette& palette) {
    static const std::array<QColor, 8> light{QColor(0, 114, 178),  QColor(213, 94, 0),  QColor(0, 128, 96),
                                             QColor(170, 80, 140), QColor(150, 105, 0), QColor(60, 150, 210),
                                             QColor(90, 90, 90),   QColor(120, 60, 190)};
    static const std::array<QColor, 8> dark{QColor(86, 180, 233),  QColor(240, 140, 60), QColor(60, 200, 160),
                                            QColor(225, 150, 200), QColor(230, 200, 80), QColor(130, 170, 255),
                                            QColor(180, 180, 180), QColor(190, 150, 250)};
    const auto at = static_cast<std::size_t>(index) % light.size();
    return isDark(palette) ? dark[at] : light[at];
}

QColor onCanvas(const QColor& paper, const QPalette& palette) {
    if (!isDark(palette)) return paper;
    float h, s, l, a;
    paper.getHslF(&h, &s, &l, &a);
    // White paper turns into the canvas, black ink into light grey; strong hues keep their strength.
    const double turned = 0.10 + (1.0 - l) * 0.76;
    const double floor = s > 0.4 && l < 0.6 ? std::max(turned, 0.62) : turned;
    return QColor::fromHslF(std::max(h, 0.0f), s * 0.85f, static_cast<float>(floor), a);
}

QIcon icon(const QString& name) { return QIcon(new TintedIcon(name)); }

void showWhenEmpty(QAbstractItemView* list, const QString& advice) {
    auto* label = new QLabel(advice, list->viewport());
    label->setAlignment(Qt::AlignCenter);
    label->setWordWrap(true);
    label->setMargin(margin);
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    makeCaption(label);
    auto* layout = new QVBoxLayout(list->viewport());
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(label);
    const auto update = [label, model = list->model()] { label->setVisible(model->rowCount() == 0); };
    QObject::connect(list->model(), &QAbstractItemModel::rowsInserted, label, update);
    QObject::connect(list->model(), &QAbstractItemModel::rowsRemoved, label, update);
    QObject::connect(list->model(), &QAbstractItemModel::modelReset, label, update);
    update();
}

namespace {

class WrappingDelegate : public QStyledItemDelegate {
public:
    explicit WrappingDelegate(QTreeView* view) : QStyledItemDelegate(view), view_(view) {}

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyleOptionViewItem narrow = option;  // views ask without a width
        narrow.rect = QRect(0, 0, view_->columnWidth(index.column()) - indentOf(index), option.fontMetrics.height());
        const int height = QStyledItemDelegate::sizeHint(narrow, index).height();
        const bool isOneLine = height < 2 * option.fontMetrics.height();
        return {0, isOneLine ? height : height + 2 * unit};  // air between rows, as those of one line have it
    }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->features |= QStyleOptionViewItem::WrapText;
        option->text = breakableAtSigns(option->text);
    }

private:
    /// What the levels above leave free in front of the first column.
    int indentOf(const QModelIndex& index) const {
        if (index.column() != view_->header()->logicalIndex(0)) return 0;
        int depth = view_->rootIsDecorated() ? 1 : 0;
        for (QModelIndex above = index.parent(); above.isValid(); above = above.parent()) ++depth;
        return depth * view_->indentation();
    }

    QTreeView* view_;
};

}  // namespace

void wrapColumn(QTreeView* view, int column) {
    auto* delegate = new WrappingDelegate(view);
    view->setUniformRowHeights(false);
    view->setItemDelegateForColumn(column, delegate);
    QObject::connect(view->header(), &QHeaderView::sectionResized, delegate, [delegate, view, column](int section) {
        if (section == column && view->model()->rowCount() > 0)
            Q_EMIT delegate->sizeHintChanged(view->model()->index(0, column));  // lays all rows out anew
    });
}

void makeCaption(QWidget* label) {
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * 0.9);
    label->setFont(font);
    label->setForegroundRole(QPalette::PlaceholderText);
}

bool isTypedInto(const QWidget* editor) {
    const auto* line = qobject_cast<const QLineEdit*>(editor);
    return line && line->isModified();
}

void makeQuiet(QProgressBar* bar) {
    bar->setTextVisible(false);
    QSizePolicy keeping = bar->sizePolicy();
    keeping.setRetainSizeWhenHidden(true);
    bar->setSizePolicy(keeping);
    bar->setMaximumHeight(2 * unit);
}

void makeHeading(QWidget* label, double scale) {
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * scale);
    font.setWeight(QFont::DemiBold);
    label->setFont(font);
}

}  // namespace analogon::ui::style
