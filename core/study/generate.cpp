#include "core/study/generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/median.hpp"
#include "core/base/unit.hpp"
#include "core/measure/all_channels.hpp"
#include "core/measure/common_raster.hpp"
#include "core/measure/encoding.hpp"
#include "core/study/column_guess.hpp"
#include "core/study/composition.hpp"
#include "core/study/recorded.hpp"
#include "core/study/recording_split.hpp"
#include "core/study/start_guess.hpp"

namespace analogon {

namespace {

std::string rounded(double value) { return fmt::format("{:.3g}", value); }

/// A connector of a part that something can be joined to.
struct Place {
    int part{};
    const Port* port{};
};

class Generator {
public:
    Generator(const Library& library, const GenerateRequest& request) : library_(library), request_(request) {}

    Outcome<GeneratedStudy> run() {
        const bool ok = readColumns() && makeParts() && joinParts() && wireSignals() && wireRotational() &&
                        wireThermal() && checkOutputs();
        if (!ok) return faults_;
        guessStarts();
        Outcome<std::string> text = modelText();
        if (!text) return text.diagnostics();
        result_.study.models[result_.study.modelFile] = *text;
        describeStudy();
        return std::move(result_);
    }

private:
    bool fault(Text message, Text hint = {}, const std::string& file = {}) {
        faults_.push_back(fileError(std::move(message), file, 0, 0, std::move(hint)));
        return false;
    }
    void assume(Text text) { result_.assumptions.push_back(std::move(text)); }

    // What is measured ------------------------------------------------------------------------------------------

    bool readColumns() {
        if (request_.recordings.empty()) return fault(phrase("no measurement was given"));
        const Outcome<std::shared_ptr<const Table>> recorded = allOnOneRaster(request_.recordings.front());
        if (!recorded) {
            faults_ = recorded.diagnostics();
            return false;
        }
        const Table& table = **recorded;
        columns_ = guessColumns(table);
        isUsed_.assign(columns_.size(), false);
        if (columns_.empty() || columns_.front().quantity != Quantity::Time)
            return fault(phrase("no column of the measurement can be the time"),
                         phrase("Its values must rise from row to row: name one 't [s]'."), table.file);
        const GuessedColumn& time = columns_.front();
        if (time.isUnitAssumed && time.unit != "s")
            return fault(
                phrase("the time column '{}' has no unit in its header", time.name),
                phrase("Write it as '{} [{}]': a time without a unit is read in seconds.", time.name, time.unit),
                table.file);
        if (const Outcome<std::vector<double>> stamps = readTime(table, time.name); !stamps) {
            faults_ = stamps.diagnostics();
            return false;
        }
        assume(phrase("'{}' is the time.", time.name));
        return true;
    }

    /// The unused column of a quantity that is liked best; -1 when there is none.
    template <class Liking>
    int take(Quantity quantity, const Liking& liking) {
        int best = -1;
        double bestLiking = 0;
        for (int i = 0; i < static_cast<int>(columns_.size()); ++i) {
            const GuessedColumn& column = columns_[static_cast<std::size_t>(i)];
            if (column.quantity != quantity || isUsed_[static_cast<std::size_t>(i)]) continue;
            const double value = liking(column);
            if (best < 0 || value > bestLiking) {
                best = i;
                bestLiking = value;
            }
        }
        if (best >= 0) isUsed_[static_cast<std::size_t>(best)] = true;
        return best;
    }
    int take(Quantity quantity) {
        return take(quantity, [](const GuessedColumn&) { return 0.0; });
    }
    const GuessedColumn& column(int index) const { return columns_[static_cast<std::size_t>(index)]; }

    // The chain -------------------------------------------------------------------------------------------------

    bool makeParts() {
        if (request_.domains.empty())
            return fault(phrase("no domain was given"),
                         phrase("Known are: {}.", fmt::join(knownDomains(library_), ", ")));
        for (const std::string& domain : request_.domains) {
            Outcome<DomainPart> part = readDomainPart(library_, domain);
            if (!part) {
                faults_ = part.diagnostics();
                return false;
            }
            part->name = composition_.freeName(part->name);
            part->centre = {60.0 * static_cast<double>(parts_.size()) - 60, 0};
            parts_.push_back(std::move(*part));
        }
        nextRight_ = {parts_.back().centre.x + 60, 0};
        const bool turns = std::any_of(parts_.begin(), parts_.end(), [](const DomainPart& part) {
            return std::any_of(part.ports.begin(), part.ports.end(),
                               [](const Port& port) { return port.domain == Domain::Rotational; });
        });
        // Between the chain and the outputs stand load and sensors, and before them a rotor where one is needed.
        outputsAt_ = parts_.back().centre.x + (turns && !hasInertia() ? 190 : 130);
        return true;
    }

    /// Joins each pair of parts, the nearest in the list first, through connectors that fit: an outgoing one (_b) of
    /// one and an ingoing one (_a) of the other. Several may give their heat to one body.
    bool joinParts() {
        const int count = static_cast<int>(parts_.size());
        std::vector<int> group(parts_.size());
        for (int i = 0; i < count; ++i) group[static_cast<std::size_t>(i)] = i;
        for (int distance = 1; distance < count; ++distance)
            for (int i = 0; i + distance < count; ++i)
                for (const Domain domain : {Domain::Rotational, Domain::Heat})
                    if (joinPair(i, i + distance, domain)) {
                        const int from = group[static_cast<std::size_t>(i + distance)],
                                  to = group[static_cast<std::size_t>(i)];
                        std::replace(group.begin(), group.end(), from, to);
                    }
        for (int i = 1; i < count; ++i)
            if (group[static_cast<std::size_t>(i)] != group[0])
                return fault(phrase("no connector joins {} to the rest of the chain",
                                    request_.domains[static_cast<std::size_t>(i)]),
                             phrase("A domain that both have in common is missing between them."));
        return true;
    }

    bool joinPair(int i, int j, Domain domain) {
        for (const auto& [from, to] : {std::pair{i, j}, {j, i}})
            for (const Port& out : parts_[static_cast<std::size_t>(from)].ports)
                for (const Port& in : parts_[static_cast<std::size_t>(to)].ports) {
                    const bool fits = out.domain == domain && in.domain == domain && isOutgoing(out) && !isOutgoing(in);
                    const std::string outName = connector({from, &out}), inName = connector({to, &in});
                    const bool isTaken = composition_.isConnected(outName) ||
                                         (domain == Domain::Rotational && composition_.isConnected(inName));
                    if (!fits || isTaken) continue;
                    composition_.connect(outName, inName, domain);
                    assume(phrase("{} and {} are joined by {} and {}.", parts_[static_cast<std::size_t>(from)].name,
                                  parts_[static_cast<std::size_t>(to)].name, outName, inName));
                    return true;
                }
        return false;
    }

    std::string connector(const Place& place) const {
        return parts_[static_cast<std::size_t>(place.part)].name + '.' + place.port->name;
    }

    std::vector<Place> open(Domain domain, bool outgoing) const {
        std::vector<Place> places;
        for (int i = 0; i < static_cast<int>(parts_.size()); ++i)
            for (const Port& port : parts_[static_cast<std::size_t>(i)].ports)
                if (port.domain == domain && isOutgoing(port) == outgoing &&
                    !composition_.isConnected(connector({i, &port})))
                    places.push_back({i, &port});
        return places;
    }

    // Components around it --------------------------------------------------------------------------------------

    /// A free place in the column right of the chain.
    Point right() {
        const Point point = nextRight_;
        nextRight_.y -= 50;
        return point;
    }

    std::string addInput(const std::string& base, int columnIndex, const std::string& unit) {
        const double y = inputs_.empty() ? 0 : -50.0 * static_cast<double>(inputs_.size() + 1);
        const std::string name =
            composition_.add("Interfaces.RealInput", base, {-140, y}, "measured: " + column(columnIndex).name,
                             {{"unit", '"' + unit + '"'}});
        inputs_[name] = columnIndex;
        return name;
    }

    void addOutput(const std::string& base, int columnIndex, const std::string& unit, const std::string& from,
                   double y) {
        const std::string name =
            composition_.add("Interfaces.RealOutput", base, {outputsAt_, y}, "measured: " + column(columnIndex).name,
                             {{"unit", '"' + unit + '"'}});
        outputs_[name] = columnIndex;
        composition_.connect(from, name, Domain::RealOutput);
        assume(phrase("{} is compared with '{}'.", from, column(columnIndex).name));
    }

    // Signals ---------------------------------------------------------------------------------------------------

    bool wireSignals() {
        double y = 50;
        for (DomainPart& part : parts_) {
            for (const SignalPort& input : part.inputs)
                if (!wireInput(part, input)) return false;
            for (const SignalPort& output : part.outputs)
                if (areConvertible(output.unit, "A")) {
                    const int index =
                        take(Quantity::Current, [](const GuessedColumn& c) { return c.isSupply ? 0.0 : 1.0; });
                    if (index < 0) continue;
                    addOutput(output.name, index, output.unit, part.name + '.' + output.name, y);
                    data_.current = column(index).values;
                    y += 30;
                }
        }
        return true;
    }

    bool wireInput(const DomainPart& part, const SignalPort& input) {
        const std::string to = part.name + '.' + input.name;
        if (!areConvertible(input.unit, "V"))
            return fault(phrase("nothing is known that could drive {} [{}]", to, input.unit));
        int index = take(Quantity::Voltage, likingOfVoltage);
        if (index < 0 && voltageInput_.empty()) return wireDuty(to);
        if (index < 0) {
            composition_.connect(voltageInput_, to, Domain::RealInput);
            assume(phrase("{} gets the same voltage.", to));
            return true;
        }
        voltageInput_ = addInput(input.name, index, input.unit);
        composition_.connect(voltageInput_, to, Domain::RealInput);
        data_.voltage = column(index).values;
        assume(phrase("{} drives {}.", column(index).label(), to));
        return true;
    }

    /// A voltage that changes and is not that of the supply.
    static double likingOfVoltage(const GuessedColumn& column) {
        const auto [low, high] = std::minmax_element(column.values.begin(), column.values.end());
        const double size = std::max(std::abs(*low), std::abs(*high));
        return (column.isSupply ? 0 : 2) + (size > 0 ? (*high - *low) / size : 0);
    }

    /// Without a voltage, a duty cycle of a supply.
    bool wireDuty(const std::string& to) {
        constexpr double supply = 12;  // [V]
        int index = -1;
        for (int i = 0; i < static_cast<int>(columns_.size()); ++i)
            if (column(i).unit == "%" && index < 0) index = i;
        if (index < 0)
            return fault(phrase("no column can drive {}: a voltage [V] is needed", to),
                         phrase("Give the column a unit in its header, as 'u [V]'."),
                         request_.recordings.front()->file);
        isUsed_[static_cast<std::size_t>(index)] = true;
        const std::string input = addInput("duty", index, "1");
        const std::string gain =
            composition_.add("Signals.Gain", "supply", {-110, 0}, "supply voltage", {{"k", rounded(supply)}});
        composition_.connect(input, gain + ".u", Domain::RealInput);
        composition_.connect(gain + ".y", to, Domain::RealInput);
        voltageInput_ = gain + ".y";
        data_.voltage = column(index).values;
        for (double& value : data_.voltage) value *= 0.01 * supply;
        assume(phrase("{} switches a supply of {:.3g} V to {}.", column(index).label(), supply, to));
        return true;
    }

    // Shafts ----------------------------------------------------------------------------------------------------

    bool wireRotational() {
        for (const Place& place : open(Domain::Rotational, false)) {
            const int torque = take(Quantity::Torque);
            if (torque < 0) {
                assume(phrase("{} is left free: no torque acts on it.", connector(place)));
                continue;
            }
            const Point at{parts_.front().centre.x - 40, -60};
            const std::string source = composition_.add("Sources.PrescribedTorque", "drive", at, "measured torque");
            composition_.connect(addInput("tau", torque, "N.m"), source + ".tau", Domain::RealInput);
            composition_.connect(source + ".flange", connector(place), Domain::Rotational);
            assume(phrase("{} drives {}.", column(torque).label(), connector(place)));
        }
        for (const Place& place : open(Domain::Rotational, true)) wireShaftEnd(place);
        return true;
    }

    bool hasInertia() const {
        return std::any_of(parts_.begin(), parts_.end(),
                           [](const DomainPart& part) { return part.package == "Mechanics"; });
    }

    void wireShaftEnd(const Place& place) {
        std::string end = connector(place);
        if (!hasInertia()) {
            const Point at{nextRight_.x, 0};
            nextRight_.x += 60;
            rotor_ = composition_.add("Mechanics.Inertia", "rotor", at, "what turns");
            composition_.connect(end, rotor_ + ".flange_a", Domain::Rotational);
            assume(phrase("An inertia turns with {}: the basic class of a motor has none.", end));
            end = rotor_ + ".flange_b";
        }
        load_ = composition_.add("Mechanics.QuadraticLoad", "load", right(), "load");
        composition_.connect(end, load_ + ".flange", Domain::Rotational);
        assume(phrase("A load that grows with the square of the speed (pump, fan) hangs on {}.", end));
        if (const int speed = take(Quantity::Speed); speed >= 0) {
            const Point at = right();
            const std::string sensor = composition_.add("Sensors.SpeedSensor", "speedSensor", at, "");
            composition_.connect(end, sensor + ".flange", Domain::Rotational);
            addOutput("w", speed, "rad/s", sensor + ".w", at.y);
            data_.speed = column(speed).values;
        }
        if (const int angle = take(Quantity::Angle); angle >= 0) {
            const Point at = right();
            const std::string sensor = composition_.add("Sensors.AngleSensor", "angleSensor", at, "");
            composition_.connect(end, sensor + ".flange", Domain::Rotational);
            addOutput("phi", angle, "rad", sensor + ".phi", at.y);
        }
    }

    // Heat ------------------------------------------------------------------------------------------------------

    bool wireThermal() {
        const auto likesBody = [](const GuessedColumn& c) {
            return (c.isBody ? 1.0 : 0.0) - (c.isSurroundings ? 2.0 : 0.0);
        };
        const std::vector<Place> ends = open(Domain::Heat, true);
        if (!ends.empty()) wireSurroundings(ends);
        for (int i = 0; i < static_cast<int>(parts_.size()); ++i)
            for (const Port& port : parts_[static_cast<std::size_t>(i)].ports) {
                if (port.domain != Domain::Heat || isOutgoing(port)) continue;
                const Place body{i, &port};
                wireHeatSource(body);
                if (const int index = take(Quantity::Temperature, likesBody); index >= 0) {
                    const Point at{parts_[static_cast<std::size_t>(i)].centre.x, -50};
                    const std::string sensor =
                        composition_.add("Sensors.TemperatureSensor", "temperatureSensor", at, "");
                    composition_.connect(connector(body), sensor + ".port", Domain::Heat);
                    addOutput("T", index, "K", sensor + ".T", at.y);
                    if (data_.bodyTemperature.empty()) {
                        data_.bodyTemperature = column(index).values;
                        bodyColumn_ = column(index).name;
                    }
                }
            }
        return true;
    }

    /// A body that nothing heats, and a measured heat flow.
    void wireHeatSource(const Place& body) {
        if (composition_.isConnected(connector(body))) return;
        const int heat = take(Quantity::HeatFlow);
        if (heat < 0) return;
        const Point at{parts_[static_cast<std::size_t>(body.part)].centre.x - 40, -60};
        const std::string source = composition_.add("Sources.PrescribedHeatFlow", "heating", at, "measured heat");
        composition_.connect(addInput("Q_flow", heat, "W"), source + ".Q_flow", Domain::RealInput);
        composition_.connect(source + ".port", connector(body), Domain::Heat);
        assume(phrase("{} heats {}.", column(heat).label(), connector(body)));
    }

    void wireSurroundings(const std::vector<Place>& ends) {
        int count = 0, named = 0;
        for (const GuessedColumn& c : columns_) {
            count += c.quantity == Quantity::Temperature;
            named += c.quantity == Quantity::Temperature && c.isSurroundings;
        }
        // One temperature without a telling name is the body's when nothing else could be compared with the model.
        const bool isOnlyOutput = named == 0 && count == 1 && outputs_.empty();
        const auto likes = [](const GuessedColumn& c) {
            return (c.isSurroundings ? 2.0 : 0.0) - (c.isBody ? 1.0 : 0.0);
        };
        const auto isPlausible = [&] { return named > 0 || count > 1 || (count == 1 && !isNamedBody()); };
        const int index = !isOnlyOutput && isPlausible() ? take(Quantity::Temperature, likes) : -1;
        const Point at = right();
        std::string source;
        if (index >= 0) {
            source = composition_.add("Sources.PrescribedTemperature", "ambient", at, "measured temperature");
            composition_.connect(addInput("T_amb", index, "K"), source + ".T", Domain::RealInput);
            data_.surroundingTemperature = column(index).values;
            surroundingColumn_ = column(index).name;
        } else {
            source = composition_.add("Sources.FixedTemperature", "ambient", at, "surroundings", {{"T", "293.15"}});
        }
        for (const Place& end : ends) {
            composition_.connect(connector(end), source + ".port", Domain::Heat);
            if (index >= 0) {
                assume(phrase("{} is the temperature at {}.", column(index).label(), connector(end)));
            } else {
                assume(phrase("The temperature at {} is 293.15 K: no column of the surroundings was found.",
                              connector(end)));
            }
        }
    }

    bool isNamedBody() const {
        return std::any_of(columns_.begin(), columns_.end(), [](const GuessedColumn& c) {
            return c.quantity == Quantity::Temperature && c.isBody && !c.isSurroundings;
        });
    }

    bool checkOutputs() {
        if (!outputs_.empty()) return true;
        return fault(
            phrase("the measurement has no column that the model could be compared with"),
            phrase("Wanted is a current [A], a speed [rad/s], an angle [rad] or a temperature [K] that the model does "
                   "not already take as its input; give the columns their units in the header."),
            request_.recordings.front()->file);
    }

    // Start values ----------------------------------------------------------------------------------------------

    void guessStarts() {
        data_.time = columns_.front().values;
        double torqueConstant = 0.02;
        for (DomainPart& part : parts_) {
            if (part.package == "ElectricThermal") {
                fit(part, "R", guessResistance(data_));
                fit(part, "alpha", {0.004, 0, 0.02, phrase("a metal")}, ParameterScale::Linear);
            } else if (part.package == "ElectricMechanical") {
                const auto [resistance, k] = guessMotor(data_);
                fit(part, "R", resistance);
                fit(part, "k", k);
                part.values["L"] = "0";
                assume(phrase("{}.L is 0: the inductance is left out until the data call for it.", part.name));
                torqueConstant = k.value;
            }
        }
        const double resistance = guessMotor(data_).resistance.value;
        for (DomainPart& part : parts_) {
            if (part.package == "Mechanics") {
                fit(part, "J1", guessInertia(data_, resistance, torqueConstant));
                part.values["J2"] = "0";
                assume(phrase("{0}.J2 is 0 and {0}.r is 1: all inertia is in J1, there is no gear.", part.name));
            } else if (part.package == "MechanicThermal") {
                fit(part, "b", guessFriction(data_, torqueConstant));
            } else if (part.package == "ThermalFluid") {
                guessThermal(part);
            }
        }
        if (!rotor_.empty()) fitExtra(rotor_, "J", guessInertia(data_, resistance, torqueConstant));
        if (!load_.empty()) fitExtra(load_, "k_q", guessQuadraticLoad(data_, torqueConstant));
    }

    void guessThermal(DomainPart& part) {
        constexpr double surface = 1e-3, usualTemperature = 293.15;  // [m2], [K]
        const StartGuess conductance = guessConductance(data_);
        const double fluid =
            data_.surroundingTemperature.empty() ? usualTemperature : median(data_.surroundingTemperature);
        const double perCoefficient = surface * std::pow(fluid / 3.6, 0.78);  // the law of BasicThermalFluid
        part.values["A"] = rounded(surface);
        assume(phrase("{0}.A is {1:.3g} m2 and stays: only the product of {0}.A and {0}.c_o shows in the data.",
                      part.name, surface));
        fit(part, "C", guessHeatCapacity(data_, conductance.value));
        fit(part, "c_o",
            {conductance.value / perCoefficient, conductance.min / perCoefficient, conductance.max / perCoefficient,
             conductance.reason});
        const std::string start = part.name + ".T_start";
        if (!bodyColumn_.empty()) {
            starts_[start] = bodyColumn_;
        } else if (!surroundingColumn_.empty()) {
            starts_[start] = surroundingColumn_;
            assume(phrase("{} starts at the temperature of its surroundings ('{}').", part.name, surroundingColumn_));
        }
    }

    void fit(DomainPart& part, const std::string& parameter, const StartGuess& guess,
             ParameterScale scale = ParameterScale::Logarithmic) {
        part.values[parameter] = rounded(guess.value);
        addParameter(part.name + '.' + parameter, guess, scale);
    }

    void fitExtra(const std::string& component, const std::string& parameter, const StartGuess& guess) {
        composition_.setModification(component, parameter, rounded(guess.value));
        addParameter(component + '.' + parameter, guess, ParameterScale::Logarithmic);
    }

    void addParameter(const std::string& name, const StartGuess& guess, ParameterScale scale) {
        StudyParameter parameter;
        parameter.min = std::stod(rounded(guess.min));
        parameter.max = std::stod(rounded(guess.max));
        parameter.scale = scale;
        result_.study.parameters[name] = parameter;
        assume(phrase("{} is fitted from {:.3g} ({}) within {:.3g} … {:.3g}.", name, guess.value,
                      guess.reason.empty() ? phrase("a usual value") : guess.reason, guess.min, guess.max));
    }

    // The study -------------------------------------------------------------------------------------------------

    Outcome<std::string> modelText() {
        for (const DomainPart& part : parts_)
            composition_.addNamed(part.className, part.name, part.centre, "", {part.values.begin(), part.values.end()});
        const double lowest = std::min(nextRight_.y + 20, -50.0 * static_cast<double>(inputs_.size()) - 20);
        return composition_.text(library_, request_.className, fmt::format("{}", fmt::join(request_.domains, ", ")),
                                 {{-160, lowest}, {outputsAt_ + 20, 120}});
    }

    void describeStudy() {
        Study& study = result_.study;
        study.className = request_.className;
        study.name = request_.className;
        const std::size_t count = request_.recordings.size();
        Composition names;  // of the experiments
        for (std::size_t i = 0; i < count; ++i) {
            const Table& table = *request_.recordings[i];
            StudyExperiment experiment;
            experiment.name = names.freeName(inUtf8(std::filesystem::path(table.file).stem().string()));
            experiment.role = i > 0 && i + 1 == count ? Role::Validate : Role::Fit;
            std::error_code code;
            experiment.file = std::filesystem::exists(table.file, code)
                                  ? std::filesystem::absolute(table.file, code).string()
                                  : table.file;
            experiment.timeColumn = columns_.front().name;
            for (const auto& [name, index] : inputs_) experiment.inputs[name] = column(index).mapping();
            for (const auto& [name, index] : outputs_) experiment.outputs[name] = column(index).mapping();
            for (const auto& [parameter, from] : starts_) experiment.initial[parameter] = ColumnStart{from, {}};
            study.tables[tableKey(experiment)] = request_.recordings[i];
            study.experiments.push_back(std::move(experiment));
        }
        if (count == 1) splitExperiment();
        for (std::size_t i = 0; i < columns_.size(); ++i)
            if (columns_[i].isUnitAssumed && (isUsed_[i] || i == 0))
                assume(phrase("'{}' is in {}: its header gives no unit, its name does.", columns_[i].name,
                              columns_[i].unit));
    }

    /// The first part of one recording is fitted, the rest validates.
    void splitExperiment() {
        constexpr double usual = 0.7;
        std::vector<StudyExperiment>& experiments = result_.study.experiments;
        const std::vector<double>& time = columns_.front().values;
        const std::size_t rest = restingCut();
        const std::size_t cut =
            rest > 0 ? rest : static_cast<std::size_t>(usual * static_cast<double>(time.size() - 1));
        experiments.push_back(experiments.front());
        const std::string name = experiments[0].name;
        experiments[0].name = name + " (first part)";
        experiments[0].range = {time.front(), time[cut]};
        experiments[1].name = name + " (second part)";
        experiments[1].role = Role::Validate;
        experiments[1].range = {time[cut], time.back()};
        assume(phrase(
            "The recording up to {:.3g} s is fitted, the rest validates{}.", time[cut],
            rest > 0
                ? phrase(": there it stands as at its beginning")
                : phrase(", although the model starts it at rest and the component does not; a recording of its own "
                         "for the validation is better")));
    }

    std::size_t restingCut() const {
        std::vector<std::vector<double>> channels;
        for (const auto* const signals : {&inputs_, &outputs_})
            for (const auto& [name, index] : *signals)
                if (column(index).name != bodyColumn_ && column(index).name != surroundingColumn_)
                    channels.push_back(column(index).values);
        return restingSample(channels);
    }

    const Library& library_;
    const GenerateRequest& request_;
    GeneratedStudy result_;
    Diagnostics faults_;
    std::vector<GuessedColumn> columns_;
    std::vector<bool> isUsed_;
    std::vector<DomainPart> parts_;
    Composition composition_;
    std::map<std::string, int> inputs_, outputs_;  // top-level signal -> column
    std::map<std::string, std::string> starts_;    // parameter -> column
    std::string voltageInput_, rotor_, load_, bodyColumn_, surroundingColumn_;
    Point nextRight_;
    double outputsAt_{};  // x of the outputs in the diagram
    GuessData data_;
};

}  // namespace

Outcome<GeneratedStudy> generateStudy(const Library& library, const GenerateRequest& request) {
    return Generator(library, request).run();
}

}  // namespace analogon
