#include "core/flat/external_functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/flat/external_table.hpp"
#include "core/flat/random_numbers.hpp"
#include "core/flat/translator.hpp"

namespace analogon {
namespace {

using Kind = syntax::Expression::Kind;

class ExternalCall {
public:
    ExternalCall(Flattening& work, const syntax::ClassDefinition& function, const syntax::Expression& call,
                 const Scope& scope)
        : work_(work),
          pool_(work.pool),
          external_(*function.external),
          function_(function),
          call_(call),
          scope_(scope) {}

    bool run() {
        const std::string& name = external_.function.empty() ? function_.name : external_.function;
        if (external_.language == "builtin") return builtin(name);
        for (const syntax::Expression& argument : external_.arguments) {
            auto value = work_.translator->translate(argument, scope_);
            if (!value) return false;
            arguments_.push_back(std::move(*value));
        }
        constexpr std::string_view tables = "ModelicaStandardTables_Combi";
        if (name.starts_with(tables)) return table(name.substr(tables.size()));
        if (name.starts_with("ModelicaStrings_")) return strings(name.substr(16));
        if (name.starts_with("ModelicaRandom_")) return random(name.substr(15));
        if (name == "ModelicaInternal_print") return print();
        return refuse(phrase("the external function '{}' is not known", name));
    }

private:
    bool refuse(const Text& why, const Text& hint = {}) {
        work_.messages.error(why, call_.name.span.valid() ? call_.name.span : call_.span, hint);
        return false;
    }
    bool refuse(const Diagnostics& faults) {
        for (const Diagnostic& fault : faults) {
            const bool isInFile = !fault.place.file.empty();
            refuse(isInFile ? phrase("{}: {}", fault.place.file, fault.message) : fault.message, fault.hint);
        }
        return false;
    }

    bool give(Value value) {
        if (!external_.result || external_.result->kind != Kind::Reference)
            return refuse(phrase("the external function '{}' gives nothing", external_.function));
        return work_.translator->setLocal(external_.result->name.parts.front().identifier, std::move(value));
    }
    bool give(ExpressionId value, FlatType type = FlatType::Real) { return give(Value::scalar(type, value)); }

    /// `external "builtin" y = sin(u)`
    bool builtin(const std::string& name) {
        syntax::Expression call;
        call.kind = Kind::Call;
        call.span = call_.span;
        call.name.parts.push_back({name, {}, call_.span});
        call.name.span = call_.span;
        call.operands = external_.arguments;
        auto value = callFunction(work_, call, scope_);
        return value && give(std::move(*value));
    }

    // ------------------------------------------------------------------------------------------------- arguments

    std::optional<double> number(std::size_t i) {
        if (i >= arguments_.size() || arguments_[i].elements.size() != 1) return std::nullopt;
        return work_.translator->constantNumber(arguments_[i].elements[0], true);
    }
    std::optional<std::vector<double>> numbers(std::size_t i) {
        std::vector<double> values;
        for (const ExpressionId element : arguments_[i].elements) {
            const auto value = work_.translator->constantNumber(element, true);
            if (!value) return std::nullopt;
            values.push_back(*value);
        }
        return values;
    }
    std::optional<std::string> text(std::size_t i) {
        if (i >= arguments_.size() || arguments_[i].texts.size() != 1) return std::nullopt;
        return arguments_[i].isOpen ? std::nullopt : std::optional(arguments_[i].texts[0]);
    }
    const ExternalTable* object(std::size_t i) {
        if (i >= arguments_.size() || !arguments_[i].isObject()) return nullptr;
        return &work_.tables[static_cast<std::size_t>(arguments_[i].object)];
    }

    // ---------------------------------------------------------------------------------------------------- tables

    bool table(const std::string& name) {
        const auto separator = name.find('_');
        const std::string which = name.substr(0, separator), what = name.substr(separator + 1);
        if (what == "init3") return make(which);
        const ExternalTable* const table = object(0);
        if (!table) return refuse(phrase("the table of '{}' must be known before the simulation", call_.name.text()));
        if (what == "getValue") return which == "Table2D" ? surface(*table) : column(*table);
        if (what == "minimumTime" || what == "minimumAbscissa" || what == "maximumTime" || what == "maximumAbscissa")
            return abscissa(*table, what.starts_with("min"));
        if (what == "nextTimeEvent") return next(*table);
        return refuse(phrase("the external function '{}' is not known", "ModelicaStandardTables_Combi" + name));
    }

    bool abscissa(const ExternalTable& table, bool isMinimum) {
        const double first = isMinimum ? table.first : table.last, second = isMinimum ? table.first2 : table.last2;
        if (table.kind != ExternalTable::Kind::TwoDimensions) return give(pool_.constant(first));
        Value both;
        both.dimensions = {2};
        both.elements = {pool_.constant(first), pool_.constant(second)};
        // given as an argument: ModelicaStandardTables_CombiTable2D_minimumAbscissa(tableID, uMin)
        return work_.translator->setLocal(external_.arguments.back().name.parts.front().identifier, std::move(both));
    }

    /// The values of the table. Abscissas shape the equations, and all of it does where slopes are chosen by the grid.
    std::optional<Matrix> matrix(bool isSurface, bool isStructural, OpenEntries& open) {
        const Value& given = arguments_[2];
        if (given.dimensions.size() != 2) return std::nullopt;
        Matrix values{static_cast<std::size_t>(given.dimensions[0]), static_cast<std::size_t>(given.dimensions[1]), {}};
        for (std::size_t i = 0; i < given.elements.size(); ++i) {
            const bool isAbscissa = i % values.columns == 0 || (isSurface && i < values.columns);
            if (isStructural || isAbscissa) {
                const auto number = work_.translator->constantNumber(given.elements[i], true);
                if (!number) return std::nullopt;
                values.values.push_back(*number);
                continue;
            }
            const auto ordinate = work_.translator->ordinate(given.elements[i]);
            if (!ordinate) return std::nullopt;
            const bool isNumber = pool_.isConstant(*ordinate);
            values.values.push_back(isNumber ? pool_[*ordinate].value : 0);
            if (!isNumber) open.entries.emplace(i, *ordinate);
        }
        return values;
    }

    bool make(const std::string& which) {
        const bool isTime = which == "TimeTable", isSurface = which == "Table2D";
        const auto file = text(0), name = text(1);
        const std::size_t columnsAt = isTime ? 6 : 5, first = isSurface ? 5 : columnsAt + 2;
        const auto smoothness = number(first), extrapolation = number(first + 1);
        const std::size_t rest = isTime ? first + 5 : first + 3;
        const auto delimiter = text(rest);
        const auto header = number(rest + 1);
        const auto smooth = static_cast<Smoothness>(static_cast<int>(smoothness.value_or(1)));
        OpenEntries open{&pool_, {}};
        auto entries = matrix(isSurface, isSurface && smooth == Smoothness::Akima, open);
        if (!file || !name || !smoothness || !extrapolation || !entries)
            return refuse(phrase("the table of '{}' must be known before the simulation", call_.name.text()));
        Matrix& matrix = *entries;
        if (*file != "NoName" && !file->empty()) {
            Outcome<Matrix> read =
                readTableFile(*file, *name, delimiter.value_or(","), static_cast<int>(header.value_or(0)));
            if (!read) return refuse(read.diagnostics());
            matrix = std::move(*read);
            open.entries.clear();
        } else if (*name != "NoName") {
            return refuse(phrase("the table \"{}\" of a function 'usertab' is not supported", *name),
                          phrase("give the table by its values or in a file"));
        }
        std::vector<int> columns;
        if (!isSurface) {
            const auto given = numbers(columnsAt);
            if (!given) return refuse(phrase("the columns of the table must be known before the simulation"));
            for (const double column : *given) columns.push_back(static_cast<int>(column));
        }
        const auto beyond = static_cast<TableExtrapolation>(static_cast<int>(*extrapolation));
        Outcome<ExternalTable> made =
            isSurface ? twoDimensional(matrix, smooth, beyond, open)
            : isTime  ? timeTable(matrix, columns, smooth, beyond, number(5).value_or(0), number(first + 2).value_or(0),
                                  static_cast<TimeEvents>(static_cast<int>(number(first + 3).value_or(1))), open)
                      : oneDimensional(matrix, columns, smooth, beyond, open);
        if (!made) return refuse(made.diagnostics());
        Value value;
        value.object = static_cast<int>(work_.tables.size());
        work_.tables.push_back(std::move(*made));
        return give(std::move(value));
    }

    bool column(const ExternalTable& table) {
        const auto which = number(1);
        if (!which || *which < 1 || *which > static_cast<double>(table.columns.size()) || arguments_.size() < 3)
            return refuse(phrase("the column of the table must be known before the simulation"));
        const TableSum& lookup = table.columns[static_cast<std::size_t>(*which) - 1];
        ExpressionId at = arguments_[2].elements[0];
        if (table.kind == ExternalTable::Kind::Time && arguments_.size() > 3) {
            // Up to the next event it is the piece before it that counts, then the one behind.
            const ExpressionId rounding = pool_.constant(table.rounding);
            at = pool_.binary(Operation::Min, pool_.add(at, rounding),
                              pool_.subtract(arguments_[3].elements[0], rounding));
        }
        return give(lookup.at(pool_, at));
    }

    bool surface(const ExternalTable& table) {
        if (arguments_.size() < 3) return refuse(phrase("the table has no values"));
        const ExpressionId u1 = arguments_[1].elements[0], u2 = arguments_[2].elements[0];
        const auto sum = [&](const std::vector<TableSum>& along, const std::vector<LookupTable>& across) {
            ExpressionId all = pool_.constant(0);
            for (std::size_t j = 0; j < along.size(); ++j)
                all = pool_.add(all, pool_.multiply(pool_.table(across[j], u2), along[j].at(pool_, u1)));
            return all;
        };
        const ExpressionId inside = sum(table.along, table.across);
        if (table.alongBeyond.empty()) return give(inside);
        const auto isLess = [&](ExpressionId a, ExpressionId b) {
            return pool_.unary(Operation::NoEvent, pool_.binary(Operation::Less, a, b));
        };
        const auto isBeyond = [&](ExpressionId u, double first, double last) {
            if (first == last) return pool_.constant(0);  // one line of the grid: the same everywhere across
            return pool_.binary(Operation::Or, isLess(u, pool_.constant(first)), isLess(pool_.constant(last), u));
        };
        const ExpressionId isOutside =
            pool_.binary(Operation::Or, isBeyond(u1, table.first, table.last), isBeyond(u2, table.first2, table.last2));
        return give(pool_.ifThenElse(isOutside, sum(table.alongBeyond, table.acrossBeyond), inside));
    }

    bool next(const ExternalTable& table) {
        const ExpressionId t = arguments_[1].elements[0], rounding = pool_.constant(table.rounding);
        const ExpressionId behind = pool_.add(t, rounding);
        ExpressionId value = pool_.table(table.next, behind);
        if (table.isPeriodic) {
            const ExpressionId start = pool_.constant(table.start);
            value = pool_.ifThenElse(pool_.unary(Operation::NoEvent, pool_.binary(Operation::Less, behind, start)),
                                     start, pool_.add(behind, value));
        }
        return give(value);
    }

    // ---------------------------------------------------------------------------------------------------- random

    bool random(const std::string& what) {
        if (what == "xorshift64star") return draw(xorshift64star, 2);
        if (what == "xorshift128plus") return draw(xorshift128plus, 4);
        if (what == "xorshift1024star") return draw(xorshift1024star, 33);
        // What the generator without a state of the caller's is set to is never asked for: drawing from it is refused.
        if (what == "setInternalState_xorshift1024star") return true;
        // Two runs of a model give the same.
        if (what == "automaticGlobalSeed") return give(pool_.constant(hashOf(work_.model.name)), FlatType::Integer);
        if (what.starts_with("impureRandom"))
            return refuse(phrase("random numbers of a generator with a hidden state are not supported"),
                          phrase("draw them from a generator whose state is a variable: Modelica.Blocks.Noise, or "
                                 "Modelica.Math.Random.Generators"));
        return refuse(phrase("the external function '{}' is not known", "ModelicaRandom_" + what));
    }

    /// `(stateIn, stateOut, result)`
    bool draw(RandomStep (*generator)(ExpressionPool&, std::span<const ExpressionId>), std::size_t size) {
        if (arguments_.size() != 3 || arguments_[0].elements.size() != size)
            return refuse(phrase("the state of a random number generator has {} Integers here", size));
        RandomStep step = generator(pool_, arguments_[0].elements);
        Value next = arguments_[0];
        next.elements = std::move(step.state);
        const auto nameOf = [&](std::size_t i) { return external_.arguments[i].name.parts.front().identifier; };
        return work_.translator->setLocal(nameOf(1), std::move(next)) &&
               work_.translator->setLocal(nameOf(2), Value::scalar(FlatType::Real, step.number));
    }

    /// `print(string, fileName)`: told once, when the model is read. A file is never written.
    bool print() {
        const auto file = text(1);
        if (arguments_.empty() || arguments_[0].texts.size() != 1 || arguments_[0].texts[0].empty()) return true;
        const std::string& message = arguments_[0].texts[0];
        const bool isFile = file && !file->empty();
        work_.messages.warning(isFile ? phrase("the model prints to '{}', which is not written: {}", *file, message)
                                      : phrase("the model prints: {}", message),
                               call_.span);
        return true;
    }

    // --------------------------------------------------------------------------------------------------- strings

    /// A seed by the name of a component is another one under another name.
    bool hash(const std::string& of) {
        if (work_.instanceNames.contains(of))
            work_.messages.warning(
                phrase("random numbers follow from the name '{}': under another name they differ", of), call_.span,
                phrase("give the component a seed of its own, as with useAutomaticLocalSeed = false"));
        return give(pool_.constant(hashOf(of)), FlatType::Integer);
    }

    bool strings(const std::string& what) {
        const auto first = text(0);
        if (!first) return refuse(phrase("the text must be known before the simulation"));
        if (what == "length") return give(pool_.constant(static_cast<double>(first->size())), FlatType::Integer);
        if (what == "hashString") return hash(*first);
        if (what == "skipWhiteSpace") {
            const auto from = number(1);
            if (!from || *from < 1) return refuse(phrase("the text must be known before the simulation"));
            auto at = static_cast<std::size_t>(*from) - 1;
            while (at < first->size() && std::isspace(static_cast<unsigned char>((*first)[at]))) ++at;
            return give(pool_.constant(static_cast<double>(at + 1)), FlatType::Integer);
        }
        if (what == "substring") {
            const auto from = number(1), to = number(2);
            if (!from || !to || *from < 1) return refuse(phrase("the text must be known before the simulation"));
            const auto begin = std::min(static_cast<std::size_t>(*from) - 1, first->size());
            const auto end = std::clamp(static_cast<std::size_t>(std::max(0.0, *to)), begin, first->size());
            return give(Value::text(first->substr(begin, end - begin)));
        }
        if (what == "compare") {
            const auto second = text(1);
            const auto isCased = number(2);
            if (!second || !isCased) return refuse(phrase("the text must be known before the simulation"));
            const auto lower = [](std::string s) {
                std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return std::tolower(c); });
                return s;
            };
            const int order = *isCased != 0 ? first->compare(*second) : lower(*first).compare(lower(*second));
            Value value = Value::scalar(FlatType::Integer, pool_.constant(order < 0 ? 1 : order == 0 ? 2 : 3));
            value.enumeration = "Modelica.Utilities.Types.Compare";
            return give(std::move(value));
        }
        return refuse(phrase("the external function '{}' is not known", "ModelicaStrings_" + what));
    }

    Flattening& work_;
    ExpressionPool& pool_;
    const syntax::External& external_;
    const syntax::ClassDefinition& function_;
    const syntax::Expression& call_;
    const Scope& scope_;
    std::vector<Value> arguments_;
};

}  // namespace

bool callExternal(Flattening& work, const syntax::ClassDefinition& function, const syntax::Expression& call,
                  const Scope& scope) {
    return ExternalCall(work, function, call, scope).run();
}

}  // namespace analogon
