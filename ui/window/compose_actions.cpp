#include "ui/window/compose_actions.hpp"

#include <fmt/format.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "core/diagram/edit.hpp"
#include "ui/canvas/block_item.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/canvas/note_item.hpp"
#include "ui/document/composer.hpp"
#include "ui/document/document.hpp"
#include "ui/document/kept_picture.hpp"
#include "ui/library/chooser.hpp"
#include "ui/library/library_model.hpp"
#include "ui/library/library_panel.hpp"
#include "ui/route/route.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

QString qString(const std::string& text) { return QString::fromStdString(text); }

/// What is likeliest meant comes first: not the block's own connectors, then those that nothing is connected to yet,
/// then the nearest.
void sortByLikelihood(std::vector<std::pair<std::string, QPointF>>& connectors, const std::string& from,
                      const Diagram& diagram) {
    std::set<std::string> taken;
    for (const Wire& wire : diagram.wires) taken.insert({wire.from, wire.to});
    const std::string own = instanceOf(from);
    QPointF at;
    for (const auto& [name, place] : connectors)
        if (name == from) at = place;
    const auto rank = [&](const std::pair<std::string, QPointF>& connector) {
        const QPointF away = connector.second - at;
        return std::tuple(instanceOf(connector.first) == own, taken.contains(connector.first),
                          std::hypot(away.x(), away.y()));
    };
    std::stable_sort(connectors.begin(), connectors.end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
}

}  // namespace

ComposeActions::ComposeActions(Document& document, DiagramScene& scene, DiagramView& view, LibraryPanel& library,
                               QObject* parent)
    : QObject(parent),
      document_(document),
      scene_(scene),
      view_(view),
      library_(library),
      composer_(std::make_unique<Composer>(document)),
      chooser_(new Chooser(&view)) {
    insert_ = make(tr("Insert block …"), {Qt::Key_A, Qt::Key_Insert}, &ComposeActions::insertBlock);
    wire_ = make(tr("Connect …"), {Qt::Key_W}, &ComposeActions::startWire);
    cut_ = make(tr("Cut"), {QKeySequence::Cut}, &ComposeActions::cut);
    copy_ = make(tr("Copy"), {QKeySequence::Copy}, &ComposeActions::copy);
    paste_ = make(tr("Paste"), {QKeySequence::Paste}, &ComposeActions::paste);
    duplicate_ = make(tr("Duplicate"), {Qt::CTRL | Qt::Key_D}, &ComposeActions::duplicate);
    remove_ = make(tr("Delete"), {Qt::Key_Delete, Qt::Key_Backspace}, &ComposeActions::remove);
    rotate_ = make(tr("Rotate"), {Qt::CTRL | Qt::Key_R}, &ComposeActions::rotate);
    flipH_ = make(tr("Flip left to right"), {Qt::Key_H}, &ComposeActions::flipHorizontally);
    flipV_ = make(tr("Flip upside down"), {Qt::Key_V}, &ComposeActions::flipVertically);
    rename_ = make(tr("Rename …"), {Qt::Key_F2}, &ComposeActions::rename);
    renameModel_ = make(tr("Rename model …"), {Qt::SHIFT | Qt::Key_F2}, &ComposeActions::renameModel);
    unit_ = make(tr("Unit …"), {Qt::Key_U}, &ComposeActions::askForUnit);
    text_ = make(tr("Add text …"), {Qt::SHIFT | Qt::Key_T}, &ComposeActions::addText);
    picture_ = make(tr("Add picture …"), {Qt::SHIFT | Qt::Key_P}, &ComposeActions::pictureWanted);
    selectAll_ = make(tr("Select all"), {QKeySequence::SelectAll}, &ComposeActions::selectAll);
    group_ = make(tr("Group into a model …"), {Qt::Key_G}, &ComposeActions::group);
    group_->setObjectName("group");
    enter_ = make(tr("Open its diagram"), {Qt::CTRL | Qt::Key_Down}, &ComposeActions::enter);
    leave_ = make(tr("Back to the model around it"), {Qt::CTRL | Qt::Key_Up}, &ComposeActions::leave);
    const std::pair<QString, Edge> edges[] = {
        {tr("Align left"), Edge::Left},       {tr("Align right"), Edge::Right},
        {tr("Align top"), Edge::Top},         {tr("Align bottom"), Edge::Bottom},
        {tr("Align in a row"), Edge::Middle}, {tr("Align in a column"), Edge::Centre}};
    for (const auto& [text, edge] : edges) {
        auto* action = new QAction(text, this);
        connect(action, &QAction::triggered, this, [this, e = edge] { report(composer_->align(blocks(), e)); });
        align_.push_back(action);
    }
    for (const bool isAcross : {true, false}) {
        auto* action = new QAction(isAcross ? tr("Equal gaps in a row") : tr("Equal gaps in a column"), this);
        connect(action, &QAction::triggered, this,
                [this, isAcross] { report(composer_->distribute(blocks(), isAcross)); });
        distribute_.push_back(action);
    }
    connectGestures();
    update();
}

ComposeActions::~ComposeActions() = default;

QAction* ComposeActions::make(const QString& text, const QList<QKeySequence>& keys, void (ComposeActions::*slot)()) {
    auto* action = new QAction(text, this);
    action->setShortcuts(keys);
    action->setShortcutContext(Qt::WidgetShortcut);  // letters are keys of the diagram alone
    connect(action, &QAction::triggered, this, slot);
    view_.addAction(action);
    return action;
}

void ComposeActions::connectGestures() {
    view_.refusal = [this](const std::string& from, const std::string& to) { return composer_->refusal(from, to); };
    connect(&view_, &DiagramView::moveWanted, this,
            [this](double dx, double dy) { report(composer_->move(scene_.selection().blocks, dx, dy)); });
    view_.partedByMove = [this](double dx, double dy) {
        return composer_->partedByMove(scene_.selection().blocks, dx, dy);
    };
    connect(&view_, &DiagramView::dropWanted, this,
            [this](double dx, double dy) { report(composer_->drop(scene_.selection().blocks, dx, dy)); });
    connect(&view_, &DiagramView::wireWanted, this, [this](const QString& from, const QString& to) {
        report(composer_->addWire(from.toStdString(), to.toStdString()));
    });
    connect(&view_, &DiagramView::wireBent, this,
            [this](const QString& from, const QString& to, const std::vector<Point>& way) {
                report(composer_->lead({from.toStdString(), to.toStdString()}, way));
            });
    connect(&view_, &DiagramView::noteMoved, this, [this](double dx, double dy) {
        if (const NoteItem* note = scene_.selectedNote()) report(composer_->moveNote(note->graphic(), dx, dy));
    });
    connect(&view_, &DiagramView::noteActivated, this, &ComposeActions::editText);
    connect(&view_, &DiagramView::refused, this, &ComposeActions::told);
    connect(&view_, &DiagramView::typed, this, &ComposeActions::chooseBlock);
    connect(&view_, &DiagramView::blockActivated, this, [this](const QString& block) {
        if (document_.canEnter(block.toStdString()))
            document_.enter(block.toStdString());
        else
            Q_EMIT inspectWanted(block);
    });
    connect(&view_, &DiagramView::renameWanted, this, [this](const QString& block) {
        scene_.select(block.toStdString());
        rename();
    });
    connect(&view_, &DiagramView::menuWanted, this, [this](QPoint at) {
        auto* menu = new QMenu(&view_);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        fill(*menu);
        menu->popup(at);
    });
    connect(&scene_, &DiagramScene::selectionEdited, this, &ComposeActions::update);
    connect(&document_, &Document::modelChanged, this, &ComposeActions::update);
    connect(&document_, &Document::levelsChanged, this, &ComposeActions::update);
    connect(&document_, &Document::levelsChanged, chooser_, &QWidget::hide);
    connect(&document_, &Document::opened, chooser_, &QWidget::hide);
    connect(&library_, &LibraryPanel::placeWanted, this, &ComposeActions::placeAnywhere);
    connect(&library_, &LibraryPanel::dragged, this, [this](const QString& name, QPoint global) {
        const QPoint at = view_.viewport()->mapFromGlobal(global);
        if (!view_.isVisible() || !view_.viewport()->rect().contains(at)) return clearGhost();
        view_.setGhost(
            GhostBlock{readIcon(document_.library(), name.toStdString()), name.section('.', -1), view_.mapToScene(at)});
        view_.setParted(composer_->partedByDrop(name.toStdString(), view_.diagramPoint(at)));
    });
    connect(&library_, &LibraryPanel::dragCancelled, this, &ComposeActions::clearGhost);
    connect(&library_, &LibraryPanel::dropped, this, [this](const QString& name, QPoint global) {
        clearGhost();
        const QPoint at = view_.viewport()->mapFromGlobal(global);
        if (view_.isVisible() && view_.viewport()->rect().contains(at))
            show(composer_->dropBlock(name.toStdString(), view_.diagramPoint(at)));
    });
}

void ComposeActions::clearGhost() {
    view_.setGhost(std::nullopt);
    view_.setParted({});
}

void ComposeActions::report(bool isDone) {
    if (!isDone && !composer_->fault().isEmpty()) Q_EMIT told(composer_->fault());
}

std::vector<std::string> ComposeActions::blocks() const { return scene_.selection().blocks; }

void ComposeActions::update() {
    const DiagramSelection selected = scene_.selection();
    const bool isOpen = document_.isOpen(), hasBlocks = !selected.blocks.empty();
    const NoteItem* note = scene_.selectedNote();
    const bool isText = note && note->primitive().kind == Primitive::Kind::Text;
    for (QAction* a : {insert_, paste_, selectAll_, text_, picture_}) a->setEnabled(isOpen);
    renameModel_->setEnabled(isOpen && document_.levels().empty());
    for (QAction* a : {cut_, copy_, duplicate_, rotate_, flipH_, flipV_, group_}) a->setEnabled(hasBlocks);
    enter_->setEnabled(selected.blocks.size() == 1 && document_.canEnter(selected.blocks.front()));
    leave_->setEnabled(!document_.levels().empty());
    remove_->setEnabled(!selected.isEmpty() || note);
    rename_->setEnabled(selected.blocks.size() == 1 || isText);
    const Block* only = selected.blocks.size() == 1 ? document_.diagram().find(selected.blocks.front()) : nullptr;
    unit_->setEnabled(only && hasUnit(*only));
    wire_->setEnabled(hasBlocks);
    for (QAction* a : align_) a->setEnabled(selected.blocks.size() > 1);
    for (QAction* a : distribute_) a->setEnabled(selected.blocks.size() > 2);
}

void ComposeActions::fill(QMenu& menu) const {
    menu.addActions({insert_, wire_, text_, picture_});
    menu.addSeparator();
    menu.addActions({cut_, copy_, paste_, duplicate_, remove_, selectAll_});
    menu.addSeparator();
    menu.addActions({rename_, renameModel_, unit_});
    menu.addSeparator();
    menu.addActions({group_, enter_, leave_});
    menu.addSeparator();
    menu.addActions({rotate_, flipH_, flipV_});
    QMenu* align = menu.addMenu(tr("Align"));
    for (QAction* a : align_) align->addAction(a);
    align->addSeparator();
    for (QAction* a : distribute_) align->addAction(a);
}

/// Shows a block that was placed; without a name, why there is none.
void ComposeActions::show(const std::string& name) {
    report(!name.empty());
    if (name.empty()) return;
    scene_.select(name);
    view_.refitIfHidden();
}

std::string ComposeActions::placeAnywhere(const QString& className) {
    // Beside what is selected, else where the view looks.
    Point near = view_.diagramPoint(view_.viewport()->rect().center());
    const Block* selected = document_.diagram().find(scene_.selectedBlock().toStdString());
    if (selected) {
        const auto [low, high] = boxOf(selected->placement);
        near = {high.x + 20, (low.y + high.y) / 2 + 30};
    } else if (!document_.diagram().blocks.empty()) {
        near = {near.x - 20, near.y + 30};
    } else {
        near = {-20, 30};
    }
    // Signals come in from the left of everything and leave to its right.
    const bool isInput = className.endsWith(".RealInput"), isOutput = className.endsWith(".RealOutput");
    if ((isInput || isOutput) && !document_.diagram().blocks.empty()) {
        double left = 1e300, right = -1e300, top = -1e300;
        int others = 0;
        for (const Block& block : document_.diagram().blocks) {
            const auto [low, high] = boxOf(block.placement);
            const bool isAnother = block.isConnector && (block.domain == Domain::RealInput) == isInput;
            left = std::min(left, isAnother ? low.x + 60 : low.x);
            right = std::max(right, isAnother ? high.x - 60 : high.x);
            top = std::max(top, high.y);
            others += isAnother ? 1 : 0;
        }
        near = {isInput ? left - 70 : right + 30, top + 20 - 50.0 * others};
    }
    const Placement free = freePlacement(document_.diagram(), near, 20, 20);
    const auto [low, high] = boxOf(free);
    std::string name = composer_->addBlock(className.toStdString(), {(low.x + high.x) / 2, (low.y + high.y) / 2});
    show(name);
    view_.setFocus();
    return name;
}

void ComposeActions::chooseBlock(const QString& typed) {
    if (!document_.isOpen()) return;
    std::vector<Choice> choices;
    for (const LibraryClass* cls : document_.library().classes()) {
        using Restriction = syntax::ClassDefinition::Restriction;
        if (!isPlaceable(*cls) || cls->qualifiedName == document_.study().className) continue;
        if (cls->definition->restriction == Restriction::Connector &&
            cls->qualifiedName.find("Real") == std::string::npos)
            continue;
        const QModelIndex index = library_.model()->find(qString(cls->qualifiedName));
        choices.push_back({qString(cls->definition->name), libraryText(cls->definition->description),
                           qString(cls->qualifiedName), index.data(Qt::DecorationRole).value<QIcon>(),
                           qString(cls->definition->description)});
    }
    chooser_->choose(tr("Insert a block: type its name"), std::move(choices), typed,
                     [this](const QString& name) { placeAnywhere(name); });
}

void ComposeActions::startWire() {
    std::vector<Choice> choices;
    for (const auto& [name, at] : scene_.connectors())
        for (const std::string& block : blocks())
            if (instanceOf(name) == block) choices.push_back({qString(name), {}, qString(name), {}});
    if (choices.size() == 1) return chooseEnd(choices.front().key);
    if (choices.empty()) return Q_EMIT told(tr("This block has no connector."));
    chooser_->choose(tr("Connect from"), std::move(choices), {}, [this](const QString& from) { chooseEnd(from); });
}

void ComposeActions::chooseEnd(const QString& from) {
    std::vector<Choice> choices;
    std::vector<std::pair<std::string, QPointF>> connectors = scene_.connectors();
    sortByLikelihood(connectors, from.toStdString(), scene_.diagram());
    for (const auto& [name, at] : connectors) {
        const QString refusal = composer_->refusal(from.toStdString(), name);
        if (refusal.isEmpty()) choices.push_back({qString(name), {}, qString(name), {}});
    }
    // What drives the model, or what it is compared with, may not be there yet.
    const QString fresh = qString(composer_->signalClassFor(from.toStdString()));
    const auto own = std::find_if(choices.begin(), choices.end(), [&](const Choice& choice) {
        return instanceOf(choice.key.toStdString()) == instanceOf(from.toStdString());
    });
    const QString words = fresh.endsWith("Input") ? tr("a new input of the model") : tr("a new output of the model");
    if (!fresh.isEmpty()) choices.insert(own, {words, {}, fresh, {}});
    if (choices.empty()) return Q_EMIT told(tr("No connector of the diagram fits %1.").arg(from));
    chooser_->choose(tr("Connect %1 with").arg(from), std::move(choices), {}, [this, from, fresh](const QString& to) {
        report(composer_->addWire(from.toStdString(), to == fresh ? placeAnywhere(fresh) : to.toStdString()));
    });
}

void ComposeActions::copy() {
    const std::string text = composer_->copy(blocks());
    if (!text.empty()) QApplication::clipboard()->setText(qString(text));
    pastedText_.clear();
}

void ComposeActions::cut() {
    copy();
    remove();
}

void ComposeActions::pasteText(const std::string& text, double dx, double dy) {
    const std::vector<std::string> names = composer_->paste(text, dx, dy);
    report(!names.empty());
    if (names.empty()) return;
    scene_.setSelection({names, {}});
    view_.refitIfHidden();
}

void ComposeActions::placeDeclared(const QString& declaration) {
    double left = 10, top = 30;
    for (const Block& block : document_.diagram().blocks) {
        const auto [low, high] = boxOf(block.placement);
        left = std::min(left, low.x);
        top = std::max(top, high.y);
    }
    const auto [low, high] = boxOf(freePlacement(document_.diagram(), {left - 30, top - 10}, 20, 20));
    const std::string place = fmt::format("extent={{{{{:g},{:g}}},{{{:g},{:g}}}}}", low.x, low.y, high.x, high.y);
    pasteText("model Clipboard\n  " + declaration.toStdString() + " annotation (Placement(transformation(" + place +
                  ")));\nend Clipboard;\n",
              0, 0);
    view_.setFocus();
}

void ComposeActions::paste() {
    const std::string text = QApplication::clipboard()->text().toStdString();
    pasteCount_ = text == pastedText_ ? pasteCount_ + 1 : 1;
    pastedText_ = text;
    pasteText(text, 20.0 * pasteCount_, -20.0 * pasteCount_);
}

void ComposeActions::duplicate() { pasteText(composer_->copy(blocks()), 20, -20); }

void ComposeActions::remove() {
    const NoteItem* note = scene_.selectedNote();
    report(note ? composer_->removeNote(note->graphic()) : composer_->remove(scene_.selection()));
}

void ComposeActions::rotate() { report(composer_->rotate(blocks())); }

void ComposeActions::flipHorizontally() { report(composer_->flip(blocks(), true)); }

void ComposeActions::flipVertically() { report(composer_->flip(blocks(), false)); }

void ComposeActions::rename() {
    if (scene_.selectedNote()) return editText();
    const QString block = scene_.selectedBlock();
    if (block.isEmpty()) return;
    const auto take = [this, block](const QString& name) {
        if (name == block) return;
        const bool isDone = composer_->rename(block.toStdString(), name.toStdString());
        report(isDone);
        if (isDone) scene_.select(name.toStdString());
    };
    chooser_->askInPlace(view_.nameRect(block.toStdString()), tr("New name of %1").arg(block), block, take);
}

/// Of an input or output of the model: what its values are told in.
void ComposeActions::askForUnit() {
    const QString block = scene_.selectedBlock();
    const Block* chosen = document_.diagram().find(block.toStdString());
    if (!chosen || !hasUnit(*chosen)) return;
    chooser_->ask(tr("Unit of %1 (V, N.m, degC, rpm …)").arg(block), qString(declaredUnit(*chosen)),
                  [this, block](const QString& unit) {
                      report(composer_->setUnit(block.toStdString(), unit.trimmed().toStdString()));
                  });
}

void ComposeActions::addText() {
    if (!document_.isOpen()) return;
    chooser_->ask(tr("Text in the diagram"), {}, [this](const QString& text) {
        report(composer_->addText(text));
        view_.refitIfHidden();
    });
}

void ComposeActions::editText() {
    const NoteItem* note = scene_.selectedNote();
    if (!note || note->primitive().kind != Primitive::Kind::Text) return;
    const QRect place = view_.mapFromScene(note->sceneBoundingRect()).boundingRect();
    chooser_->askInPlace(place, tr("Text in the diagram"), qString(note->primitive().text),
                         [this](const QString& text) {
                             if (const NoteItem* now = scene_.selectedNote())
                                 report(composer_->setText(now->graphic(), text));
                         });
}

void ComposeActions::addPicture(const QString& file) {
    const Outcome<KeptPicture> picture = keptPicture(file);
    if (!picture) return Q_EMIT told(inWords(picture.diagnostics().front().message));
    report(composer_->addPicture(picture->bytes, picture->size));
    view_.refitIfHidden();
}

void ComposeActions::renameModel() {
    const QString name = qString(document_.study().className);
    chooser_->ask(tr("New name of the model"), name,
                  [this](const QString& text) { report(composer_->setClassName(text.toStdString())); });
}

void ComposeActions::group() {
    const std::vector<std::string> chosen = blocks();
    chooser_->ask(tr("Name of the new model"), qString(composer_->freeClassName()),
                  [this, chosen](const QString& name) {
                      const std::string block = composer_->group(chosen, name.toStdString());
                      report(!block.empty());
                      if (!block.empty()) scene_.select(block);
                  });
}

void ComposeActions::enter() { document_.enter(scene_.selectedBlock().toStdString()); }

void ComposeActions::leave() {
    if (document_.levels().empty()) return;
    const std::string left = document_.levels().back();
    document_.leaveTo(document_.levels().size() - 1);
    scene_.select(left);
}

void ComposeActions::selectAll() {
    DiagramSelection all;
    for (const Block& block : scene_.diagram().blocks) all.blocks.push_back(block.name);
    for (const Wire& wire : scene_.diagram().wires) all.wires.push_back({wire.from, wire.to});
    scene_.setSelection(all);
}

}  // namespace analogon::ui
