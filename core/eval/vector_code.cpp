#include "core/eval/vector_code.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace analogon {

VectorCode::Entity VectorCode::add(Space space, std::uint32_t offset, int width, bool isInMemory) {
    homes_.push_back({space, static_cast<std::uint8_t>(width), isInMemory, offset});
    return static_cast<Entity>(homes_.size() - 1);
}

VectorCode::Entity VectorCode::fresh(int width) {
    constexpr std::uint32_t line = 8;  // doubles: vectors do not straddle cache lines
    if (width > 1) scratchSize_ = (scratchSize_ + line - 1) / line * line;
    const Entity entity = add(Space::Scratch, scratchSize_, width, false);
    scratchSize_ += static_cast<std::uint32_t>(width);
    return entity;
}

const VectorCode::Step* VectorCode::madeBy(Entity entity) const {
    const std::uint32_t made = entity < madeAt_.size() ? madeAt_[entity] : 0;
    return made > 0 ? &steps_[made - 1] : nullptr;
}

const VectorCode::Step* VectorCode::productOf(Entity entity) const {
    const Step* const step = madeBy(entity);
    return step && step->operation == Operation::Multiply ? step : nullptr;
}

void VectorCode::noteReady(Entity target, const Step& step) {
    int cycles = 4;
    if (step.operation == Operation::Divide || step.operation == Operation::SquareRoot) cycles = 14;
    if (step.operation == Operation::Call) cycles = 60;
    int ready = 0;
    for (const Entity e : {step.a, step.b, step.c})
        if (e != none) ready = std::max(ready, readyAfter(e));
    ready_.resize(homes_.size());
    ready_[target] = ready + cycles;
}

VectorCode::Entity VectorCode::emit(Operation operation, int width, Entity a, Entity b, Entity c) {
    if (operation == Operation::Add && a != b) {
        // Of two products the younger one: it is waited for.
        const Entity younger = std::max(a, b), older = std::min(a, b);
        for (const Entity factor : {younger, older})
            if (const Step* product = productOf(factor))
                return emit(Operation::MultiplyAdd, width, product->a, product->b, factor == a ? b : a);
    }
    if (operation == Operation::Subtract)
        if (const Step* product = productOf(b))
            return emit(Operation::NegativeMultiply, width, product->a, product->b, a);
    // What is moved may be a place that a block fills again.
    const bool isShared = operation != Operation::Move;
    const bool isSymmetric = operation == Operation::Add || operation == Operation::Multiply;
    if (isSymmetric && b < a) std::swap(a, b);
    const Key key{static_cast<std::uint64_t>(operation) << 8 | static_cast<std::uint64_t>(width), a, b, c, 0, 0};
    if (const auto at = known_.find(key); isShared && at != known_.end()) return at->second;
    const Entity target = fresh(width);
    emitTo(target, operation, a, b, c);
    madeAt_.resize(homes_.size());
    madeAt_[target] = static_cast<std::uint32_t>(steps_.size());
    noteReady(target, steps_.back());
    if (isShared) known_.emplace(key, target);
    return target;
}

VectorCode::Entity VectorCode::emitAdvance(Entity a, Entity b, Entity c) {
    if (const Step* product = productOf(b)) {
        const auto [early, late] =
            madeBy(product->a) ? std::pair(product->b, product->a) : std::pair(product->a, product->b);
        if (!madeBy(early)) return emitAdvance(emit(Operation::Multiply, 1, a, early), late, c);
    }
    const Step* const made = madeBy(b);
    if (made && made->operation == Operation::NegativeMultiply) {
        const auto [p, q, late] = std::tuple(made->a, made->b, made->c);
        const bool firstIsLast = readyAfter(p) > readyAfter(q);
        const Entity sooner = firstIsLast ? q : p, later = firstIsLast ? p : q;
        const int early = std::max(readyAfter(a), readyAfter(sooner)) + 4;
        if (std::max({early, readyAfter(later), readyAfter(c)}) + 4 <= readyAfter(late)) {
            const Entity rest = emit(Operation::NegativeMultiply, 1, emit(Operation::Multiply, 1, a, sooner), later, c);
            return emit(Operation::MultiplyAdd, 1, a, late, rest);
        }
    }
    return emit(Operation::MultiplyAdd, 1, a, b, c);
}

void VectorCode::emitTo(Entity target, Operation operation, Entity a, Entity b, Entity c) {
    Step step;
    step.operation = operation;
    step.target = target;
    step.a = a;
    step.b = b;
    step.c = c;
    steps_.push_back(step);
}

VectorCode::Entity VectorCode::call(const void* function, const void* data, Entity a, Entity b, Entity c) {
    const Key key{static_cast<std::uint64_t>(Operation::Call) << 8,
                  a,
                  b,
                  c,
                  reinterpret_cast<std::uint64_t>(function),
                  reinterpret_cast<std::uint64_t>(data)};
    const auto [at, isNew] = known_.try_emplace(key, none);
    if (!isNew) return at->second;
    const Entity target = at->second = fresh(1);
    emitTo(target, Operation::Call, a, b, c);
    steps_.back().function = function;
    steps_.back().data = data;
    noteReady(target, steps_.back());
    return target;
}

std::vector<char> VectorCode::neededSteps() const {
    std::vector<char> isNeeded(steps_.size(), 0), isRead(homes_.size(), 0);
    for (std::size_t i = steps_.size(); i-- > 0;) {
        const Step& s = steps_[i];
        if (s.target != none && !isRead[s.target]) continue;
        isNeeded[i] = 1;
        for (const Entity e : {s.a, s.b, s.c})
            if (e != none) isRead[e] = 1;
        if (s.operation == Operation::Block)
            for (const Entity e : blocks_[s.block].reads) isRead[e] = 1;
    }
    return isNeeded;
}

std::unique_ptr<const VectorFunction> VectorFunction::make(const VectorCode& code, VectorTarget target) {
    return target == VectorTarget::Interpreter ? interpret(code) : translate(code, target);
}

void VectorCode::block(BlockFunction function, const void* data, std::vector<Entity> reads) {
    Step step;
    step.operation = Operation::Block;
    step.block = static_cast<std::uint32_t>(blocks_.size());
    steps_.push_back(step);
    blocks_.push_back({function, data, std::move(reads)});
}

}  // namespace analogon
