#pragma once

#include <QWidget>

class QHBoxLayout;

namespace analogon::ui {

class DiagramView;
class Document;

/// The way from the study's model into the component whose diagram is shown, over the diagram's upper left corner; each
/// step leads back there. Hidden in the model itself.
class Breadcrumb : public QWidget {
    Q_OBJECT

public:
    Breadcrumb(Document& document, DiagramView& view);

private:
    void refresh();

    Document& document_;
    QHBoxLayout* row_;
};

}  // namespace analogon::ui
