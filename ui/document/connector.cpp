#include "ui/document/connector.hpp"

#include "ui/route/route.hpp"

namespace analogon::ui {

bool isSignal(Domain domain) { return domain == Domain::RealInput || domain == Domain::RealOutput; }

bool isSource(const Diagram& diagram, const std::string& connector) {
    const Block* block = diagram.find(connector);
    const bool isTop = block && block->isConnector;
    return (diagram.domain(connector) == Domain::RealOutput) != isTop;
}

std::string connectorClass(const Diagram& diagram, const std::string& connector) {
    if (const Block* top = diagram.find(connector); top && top->isConnector) return top->className;
    const Block* block = diagram.find(instanceOf(connector));
    if (!block) return {};
    for (const Port& port : block->ports)
        if (block->name + "." + port.name == connector) return port.className;
    return {};
}

}  // namespace analogon::ui
