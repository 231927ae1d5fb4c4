#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/diagram/edit.hpp"

namespace analogon {

/// A model that is put together component by component, and its text at the end.
class Composition {
public:
    /// base, base2, base3 …: a name that was not given out before.
    std::string freeName(const std::string& base);

    /// Adds a component of a class of the block library, 20 units wide around a point of the diagram; returns its name.
    std::string add(const std::string& className, const std::string& base, Point centre, const std::string& description,
                    std::vector<std::pair<std::string, std::string>> modifications = {});
    /// The same with a name from freeName.
    void addNamed(const std::string& className, const std::string& name, Point centre, const std::string& description,
                  std::vector<std::pair<std::string, std::string>> modifications);
    void setModification(const std::string& component, const std::string& name, const std::string& value);

    void connect(const std::string& from, const std::string& to, Domain domain);
    bool isConnected(const std::string& connector) const { return connected_.contains(connector); }

    /// The model as Modelica text, with placements and lines.
    Outcome<std::string> text(const Library& library, const std::string& className, const std::string& description,
                              const Extent& diagram) const;

private:
    struct Connection {
        std::string from, to;
        Domain domain;
    };

    std::set<std::string> names_, connected_;
    std::vector<NewComponent> components_;
    std::vector<Connection> connections_;
};

}  // namespace analogon
