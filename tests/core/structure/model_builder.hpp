#pragma once

#include <memory>
#include <string>

#include "core/flat/flat_model.hpp"

namespace analogon::test {

/// Writes flat models by hand: m.eq(m.der("x"), -m.v("x")).
class ModelBuilder {
public:
    struct E {
        ModelBuilder* builder{};
        ExpressionId id;

        E of(ExpressionId made) const { return {builder, made}; }
        ExpressionPool& pool() const { return *builder->model_->pool; }
        friend E operator+(E a, E b) { return a.of(a.pool().add(a.id, b.id)); }
        friend E operator-(E a, E b) { return a.of(a.pool().subtract(a.id, b.id)); }
        friend E operator*(E a, E b) { return a.of(a.pool().multiply(a.id, b.id)); }
        friend E operator/(E a, E b) { return a.of(a.pool().divide(a.id, b.id)); }
        friend E operator-(E a) { return a.of(a.pool().negate(a.id)); }
        friend E operator+(E a, double b) { return a + a.builder->c(b); }
        friend E operator-(E a, double b) { return a - a.builder->c(b); }
        friend E operator*(double a, E b) { return b.builder->c(a) * b; }
        friend E operator/(double a, E b) { return b.builder->c(a) / b; }
        friend E operator-(double a, E b) { return b.builder->c(a) - b; }
        friend E operator+(double a, E b) { return b.builder->c(a) + b; }
    };

    explicit ModelBuilder(std::string name = "M") {
        model_ = std::make_shared<FlatModel>();
        model_->name = std::move(name);
        model_->pool = std::make_shared<ExpressionPool>();
    }

    FlatVariable& variable(const std::string& name) { return add(name, FlatVariability::Continuous); }
    void variables(std::initializer_list<const char*> names) {
        for (const char* name : names) variable(name);
    }
    void parameter(const std::string& name, double value) {
        add(name, FlatVariability::Parameter).binding = model_->pool->constant(value);
    }
    void parameter(const std::string& name, E value) { add(name, FlatVariability::Parameter).binding = value.id; }
    void input(const std::string& name) { variable(name).causality = FlatCausality::Input; }
    void output(const std::string& name) { variable(name).causality = FlatCausality::Output; }
    /// A start value; fixed unless said otherwise.
    void start(const std::string& name, E value, bool isFixed = true) {
        FlatVariable& v = model_->variables[model_->find(name).value];
        v.start = value.id;
        v.isFixed = isFixed;
    }
    void start(const std::string& name, double value, bool isFixed = true) { start(name, c(value), isFixed); }
    FlatVariable& operator[](const std::string& name) { return model_->variables[model_->find(name).value]; }

    E v(const std::string& name) { return {this, model_->pool->variable(model_->find(name))}; }
    E der(const std::string& name) { return {this, model_->pool->derivativeOf(model_->find(name))}; }
    E c(double value) { return {this, model_->pool->constant(value)}; }
    E time() { return {this, model_->pool->time()}; }
    E f(Operation operation, E a) { return a.of(model_->pool->unary(operation, a.id)); }
    E f(Operation operation, E a, E b) { return a.of(model_->pool->binary(operation, a.id, b.id)); }
    E delay(E signal, E time) { return signal.of(model_->pool->delay(signal.id, time.id)); }
    E ifElse(E condition, E a, E b) { return a.of(model_->pool->ifThenElse(condition.id, a.id, b.id)); }

    void eq(E left, E right) { model_->equations.push_back({left.id, right.id, {}, component_, false}); }
    void eq(E left, double right) { eq(left, c(right)); }
    void initialEq(E left, E right) { model_->initialEquations.push_back({left.id, right.id, {}, component_, false}); }
    void component(std::string name) { component_ = std::move(name); }

    std::shared_ptr<const FlatModel> model() const { return model_; }

private:
    FlatVariable& add(const std::string& name, FlatVariability variability) {
        model_->byName[name] = VariableId{static_cast<std::uint32_t>(model_->variables.size())};
        FlatVariable v;
        v.name = name;
        v.variability = variability;
        model_->variables.push_back(std::move(v));
        return model_->variables.back();
    }

    std::shared_ptr<FlatModel> model_;
    std::string component_;
};

}  // namespace analogon::test
