#include "core/eval/vector_code.hpp"

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

VectorCode::Entity VectorCode::emit(Operation operation, int width, Entity a, Entity b, Entity c) {
    const Entity target = fresh(width);
    emitTo(target, operation, a, b, c);
    return target;
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
    const Entity target = emit(Operation::Call, 1, a, b, c);
    steps_.back().function = function;
    steps_.back().data = data;
    return target;
}

void VectorCode::block(BlockFunction function, const void* data, std::vector<Entity> reads) {
    Step step;
    step.operation = Operation::Block;
    step.block = static_cast<std::uint32_t>(blocks_.size());
    steps_.push_back(step);
    blocks_.push_back({function, data, std::move(reads)});
}

}  // namespace analogon
