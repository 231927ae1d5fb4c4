#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace analogon {

struct Registers;

/// What runs vector code: machine code of this processor (x86-64 with AVX2 and FMA, or AVX-512), or an interpreter,
/// which is there everywhere.
enum class VectorTarget : std::uint8_t { Interpreter, Avx2, Avx512 };

/// Straight-line code on short vectors. Every entity is assigned once. It has a home in memory, from which it is read
/// when it was there at the start, and to which it goes when the processor runs out of registers.
class VectorCode {
public:
    using Entity = std::uint32_t;
    static constexpr Entity none = 0xffffffffu;
    /// Row and Result: the place in a table that a loop has come to.
    enum class Space : std::uint8_t { Values, Tangents, Scratch, Row, Result };

    enum class Operation : std::uint8_t {
        Add,               // a + b
        Subtract,          // a - b
        Multiply,          // a * b
        MultiplyAdd,       // a * b + c
        NegativeMultiply,  // c - a * b
        Divide,            // of values alone
        SquareRoot,        // of values alone
        Absolute,
        Less,  // 1 or 0, as the relations below
        LessEqual,
        Equal,
        NotEqual,
        Select,  // a != 0 ? b : c
        Move,    // a
        Store,   // a to its home; no result
        Call,    // a C function of a pointer (when `data` is given) and one to three values
        Block    // a call that reads and writes homes; no result
    };
    using BlockFunction = bool (*)(Registers*, const void*);

    /// The fastest that this processor and this build can run. The environment variable ANALOGON_VECTOR_WIDTH=4 asks
    /// for AVX2 on a processor that has AVX-512.
    static VectorTarget fastest();
    /// Doubles in the vectors to write code for.
    static int vectorWidth(VectorTarget target) { return target == VectorTarget::Avx2 ? 4 : 8; }

    /// An entity of `width` doubles; width 1 is a value, the same in every place of a vector. Offsets count doubles.
    Entity add(Space space, std::uint32_t offset, int width, bool isInMemory);
    /// One with a home of its own in the scratch memory.
    Entity fresh(int width);

    /// The same operation on the same operands is one entity; a sum with a product is one operation.
    Entity emit(Operation operation, int width, Entity a, Entity b = none, Entity c = none);
    /// a * b + c, in the order in which it is there earliest: where b is the product of something known from the start
    /// and something late, a waits for the first alone; where b is a difference of something late and something early,
    /// the early part is added first.
    Entity emitAdvance(Entity a, Entity b, Entity c);
    void emitTo(Entity target, Operation operation, Entity a, Entity b = none, Entity c = none);
    /// `function` is double (*)([const void* data,] double, ...), free of side effects.
    Entity call(const void* function, const void* data, Entity a, Entity b = none, Entity c = none);
    /// Calls a block after storing what it reads; what it writes is in memory afterwards. False ends the run.
    void block(BlockFunction function, const void* data, std::vector<Entity> reads);
    void store(Entity entity) { emitTo(none, Operation::Store, entity); }

    /// The code is the body of a loop over the rows of a table; all it carries from row to row goes through memory. It
    /// reads Space::Row (the row it has come to, and those after it) and writes Space::Result; sizes in doubles.
    void repeat(std::uint32_t rowSize, std::uint32_t resultSize) {
        isLoop_ = true;
        rowSize_ = rowSize;
        resultSize_ = resultSize;
    }
    bool isLoop() const { return isLoop_; }
    std::uint32_t rowSize() const { return rowSize_; }
    std::uint32_t resultSize() const { return resultSize_; }

    std::size_t scratchSize() const { return scratchSize_; }  // doubles

    struct Home {
        Space space{};
        std::uint8_t width{1};
        bool isInMemory{};
        std::uint32_t offset{};
    };
    struct Step {
        Operation operation{};
        Entity target{none}, a{none}, b{none}, c{none};
        const void *function{}, *data{};
        std::uint32_t block{none};  // index in blocks
    };
    struct BlockCall {
        BlockFunction function{};
        const void* data{};
        std::vector<Entity> reads;
    };
    const std::vector<Home>& homes() const { return homes_; }
    const std::vector<Step>& steps() const { return steps_; }
    const std::vector<BlockCall>& blocks() const { return blocks_; }
    /// By step: whether anything comes of it.
    std::vector<char> neededSteps() const;

private:
    std::vector<Home> homes_;
    std::vector<Step> steps_;
    std::vector<BlockCall> blocks_;
    std::uint32_t scratchSize_{};
    const Step* madeBy(Entity entity) const;  // null: it was there from the start
    const Step* productOf(Entity entity) const;
    int readyAfter(Entity entity) const { return entity < ready_.size() ? ready_[entity] : 0; }
    void noteReady(Entity target, const Step& step);

    std::vector<std::uint32_t> madeAt_;  // step + 1 that made an entity; 0: none
    std::vector<int> ready_;             // by entity: cycles it takes from the start, as far as one waits for the other
    using Key = std::array<std::uint64_t, 6>;
    std::map<Key, Entity> known_;
    bool isLoop_{};
    std::uint32_t rowSize_{}, resultSize_{};
};

/// A VectorCode that can be run. Const, callable from any thread.
class VectorFunction {
public:
    /// Null when it could not be translated for the target.
    static std::unique_ptr<const VectorFunction> make(const VectorCode& code, VectorTarget target);
    virtual ~VectorFunction() = default;
    /// Doubles of scratch memory to hand in.
    virtual std::size_t scratchSize() const = 0;
    /// A loop over `count` rows (VectorCode::repeat), at least one. False: a block failed.
    virtual bool run(double* values, double* tangents, double* scratch, Registers* registers, const double* rows,
                     double* results, std::int64_t count) const = 0;
    bool operator()(double* values, double* tangents, double* scratch, Registers* registers) const {
        return run(values, tangents, scratch, registers, nullptr, nullptr, 1);
    }
};

/// Null when there is no machine code here, or it cannot do this.
std::unique_ptr<const VectorFunction> translate(const VectorCode& code, VectorTarget target);
/// Slower by a small factor; results differ from those of machine code by rounding (no fused operations), and are the
/// same on every processor.
std::unique_ptr<const VectorFunction> interpret(const VectorCode& code);

}  // namespace analogon
