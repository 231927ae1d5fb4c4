#include "ui/window/generate_page.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>

#include "core/library/library.hpp"
#include "core/measure/open/read_table.hpp"
#include "core/study/domain_part.hpp"
#include "ui/document/composer.hpp"
#include "ui/library/library_model.hpp"
#include "ui/style/ink.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

/// "ElectricThermal" of "electric-thermal".
std::string packageOf(const std::string& domain) {
    std::string name;
    bool isStart = true;
    for (const char c : domain) {
        if (c != '-') name += isStart ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        isStart = c == '-';
    }
    return name;
}

}  // namespace

GeneratePage::GeneratePage(QWidget* parent)
    : QWidget(parent),
      known_(new QListWidget(this)),
      chain_(new QListWidget(this)),
      recordings_(new QListWidget(this)),
      name_(new QLineEdit(tr("Component"), this)),
      message_(new QLabel(this)),
      add_(new QPushButton(tr("Add to the chain"), this)),
      browse_(new QPushButton(tr("Add recording …"), this)),
      generate_(new QPushButton(tr("Compose the study"), this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
    auto* title = new QLabel(tr("Generate a study"), this);
    style::makeHeading(title, 1.8);
    auto* subtitle =
        new QLabel(tr("Say which domains the component joins, in the order of the chain, and give a recording: a "
                      "first model is composed, its columns are mapped and start values come from the data."),
                   this);
    subtitle->setWordWrap(true);
    const auto heading = [this](const QString& text, QWidget* buddy) {
        auto* label = new QLabel(text, this);
        style::makeHeading(label, 1.0);
        label->setBuddy(buddy);
        return label;
    };
    known_->setIconSize({32, 32});
    known_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    for (QListWidget* list : {known_, chain_}) list->setWordWrap(true);
    chain_->setIconSize({32, 32});
    chain_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    chain_->setDragDropMode(QAbstractItemView::InternalMove);
    chain_->setToolTip(tr("Drag to change the order; Delete takes one out"));
    for (QListWidget* list : {chain_, recordings_}) list->installEventFilter(this);
    known_->installEventFilter(this);
    style::showWhenEmpty(chain_, tr("Double-click a domain, or mark it and press Add to the chain."));
    style::showWhenEmpty(recordings_, tr("Drop measurement files here, or press Add recording."));
    message_->setWordWrap(true);
    generate_->setIcon(style::icon("apply"));
    generate_->setDefault(true);

    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(4 * style::unit);
    grid->setVerticalSpacing(2 * style::unit);
    grid->addWidget(heading(tr("Domains"), known_), 0, 0);
    grid->addWidget(heading(tr("Chain of the component"), chain_), 0, 1);
    grid->addWidget(known_, 1, 0);
    grid->addWidget(chain_, 1, 1);
    grid->addWidget(add_, 2, 0, Qt::AlignLeft);
    grid->addWidget(takeOutOf(chain_, "takeOutDomain"), 2, 1, Qt::AlignLeft);
    grid->addWidget(heading(tr("Recordings (the last of several is kept for validation)"), recordings_), 3, 0, 1, 2);
    grid->addWidget(recordings_, 4, 0, 1, 2);
    auto* recordingButtons = new QHBoxLayout;
    recordingButtons->setSpacing(2 * style::unit);
    recordingButtons->addWidget(browse_);
    recordingButtons->addWidget(takeOutOf(recordings_, "takeOutRecording"));
    recordingButtons->addStretch(1);
    grid->addLayout(recordingButtons, 5, 0);
    auto* nameRow = new QHBoxLayout;
    nameRow->setSpacing(2 * style::unit);
    nameRow->addWidget(heading(tr("Name of the model"), name_));
    nameRow->addWidget(name_, 1);
    grid->addLayout(nameRow, 5, 1);
    grid->setRowStretch(1, 3);
    grid->setRowStretch(4, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(message_, 1);
    buttons->addWidget(cancel_);
    buttons->addWidget(generate_);
    auto* column = new QVBoxLayout;
    column->setSpacing(3 * style::unit);
    column->addWidget(title);
    column->addWidget(subtitle);
    column->addLayout(grid, 1);
    column->addLayout(buttons);
    auto* holder = new QWidget(this);
    holder->setMaximumWidth(860);
    holder->setLayout(column);
    auto* outer = new QHBoxLayout(this);
    outer->setContentsMargins(8 * style::unit, 8 * style::unit, 8 * style::unit, 8 * style::unit);
    outer->addStretch(1);
    outer->addWidget(holder, 8);
    outer->addStretch(1);

    connect(add_, &QPushButton::clicked, this, [this] {
        if (known_->currentItem()) addDomain(known_->currentItem()->data(Qt::UserRole).toString());
    });
    connect(known_, &QListWidget::itemDoubleClicked, this,
            [this](QListWidgetItem* item) { addDomain(item->data(Qt::UserRole).toString()); });
    connect(browse_, &QPushButton::clicked, this, &GeneratePage::recordingsWanted);
    connect(generate_, &QPushButton::clicked, this, &GeneratePage::generate);
    connect(cancel_, &QPushButton::clicked, this, &GeneratePage::cancelled);
    connect(name_, &QLineEdit::textChanged, this, &GeneratePage::update);
    update();
}

QString GeneratePage::fault() const { return message_->text(); }

void GeneratePage::say(const QString& text, bool isFault) {
    style::tint(*message_, isFault ? style::fault : style::mutedText);
    message_->setText(text);
}

void GeneratePage::clear() {
    known_->clear();
    chain_->clear();
    recordings_->clear();
    if (const Outcome<Library> library = builtInLibrary())
        for (const std::string& domain : analogon::knownDomains(*library)) {
            const std::string package = packageOf(domain), cls = "Analogon." + package + ".Basic" + package;
            const LibraryClass* found = library->find(cls);
            const auto translated = [](const std::string& t) {
                return QCoreApplication::translate("Library", t.c_str());
            };
            QString text = translated(domain);
            if (found) text += "\n" + translated(found->definition->description);
            auto* item = new QListWidgetItem(classIcon(*library, cls, 32, devicePixelRatioF()), text, known_);
            item->setData(Qt::UserRole, QString::fromStdString(domain));
            item->setToolTip(text);
            constexpr int textWidth = 320;  // [px] of the narrowest window that shows both lists
            const QRect needed = fontMetrics().boundingRect(QRect(0, 0, textWidth, 400), Qt::TextWordWrap, text);
            item->setSizeHint({10, needed.height() + 2 * style::unit});
        }
    known_->setCurrentRow(0);
    update();
}

void GeneratePage::addDomain(const QString& domain) {
    for (int i = 0; i < known_->count(); ++i)
        if (known_->item(i)->data(Qt::UserRole).toString() == domain) {
            auto* item = new QListWidgetItem(known_->item(i)->icon(), known_->item(i)->text(), chain_);
            item->setData(Qt::UserRole, domain);
            item->setSizeHint(known_->item(i)->sizeHint());
        }
    update();
}

void GeneratePage::addRecording(const QString& path) {
    auto* item = new QListWidgetItem(style::icon("recording"), QFileInfo(path).fileName(), recordings_);
    item->setData(Qt::UserRole, QFileInfo(path).absoluteFilePath());
    item->setToolTip(path);
    update();
}

void GeneratePage::update() {
    const bool hasName = isModelicaName(name_->text().toStdString());
    const bool isReady = chain_->count() > 0 && recordings_->count() > 0 && hasName && !worker_.isBusy();
    generate_->setEnabled(isReady);
    say(chain_->count() == 0        ? tr("Choose at least one domain.")
        : recordings_->count() == 0 ? tr("Add a recording.")
        : !hasName                  ? tr("The name must be a Modelica name: letters, digits and _.")
                                    : QString(),
        false);
}

void GeneratePage::generate() {
    std::vector<std::string> domains;
    std::vector<std::filesystem::path> files;
    for (int i = 0; i < chain_->count(); ++i)
        domains.push_back(chain_->item(i)->data(Qt::UserRole).toString().toStdString());
    for (int i = 0; i < recordings_->count(); ++i)
        files.emplace_back(recordings_->item(i)->data(Qt::UserRole).toString().toStdString());
    generate_->setEnabled(false);
    say(tr("Composing …"), false);
    worker_.start<Outcome<GeneratedStudy>>(
        tr("Composing"),
        [domains, files, name = name_->text().toStdString()](const Progress&) -> Outcome<GeneratedStudy> {
            GenerateRequest request;
            request.domains = domains;
            request.className = name;
            for (const auto& file : files) {
                Outcome<Table> table = readTable(file);
                if (!table) return table.diagnostics();
                request.recordings.push_back(std::make_shared<const Table>(std::move(*table)));
            }
            const Outcome<Library> library = builtInLibrary();
            if (!library) return library.diagnostics();
            Outcome<GeneratedStudy> study = generateStudy(*library, request);
            if (study) study->study.name = name;
            return study;
        },
        [this](Outcome<GeneratedStudy> study) {
            update();
            if (study) return Q_EMIT generated(*study);
            QStringList reasons;
            for (const Diagnostic& d : study.diagnostics())
                reasons << (inWords(d.message) + " " + inWords(d.hint)).trimmed();
            say(reasons.join('\n'), true);
        });
}

/// Enter adds a domain, Delete takes an entry out.
bool GeneratePage::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (watched == known_ && (key == Qt::Key_Return || key == Qt::Key_Enter) && known_->currentItem()) {
        addDomain(known_->currentItem()->data(Qt::UserRole).toString());
        return true;
    }
    if (watched != known_ && (key == Qt::Key_Delete || key == Qt::Key_Backspace)) {
        takeOut(static_cast<QListWidget*>(watched));
        return true;
    }
    return false;
}

void GeneratePage::takeOut(QListWidget* list) {
    delete list->currentItem();
    update();
}

QPushButton* GeneratePage::takeOutOf(QListWidget* list, const char* name) {
    auto* button = new QPushButton(tr("Take out"), this);
    button->setObjectName(name);
    button->setEnabled(false);
    connect(list, &QListWidget::currentRowChanged, button, [button](int row) { button->setEnabled(row >= 0); });
    connect(button, &QPushButton::clicked, this, [this, list] { takeOut(list); });
    return button;
}

}  // namespace analogon::ui
