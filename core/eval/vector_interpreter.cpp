#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/eval/machine.hpp"
#include "core/eval/vector_code.hpp"

namespace analogon {
namespace {

using Entity = VectorCode::Entity;
using Operation = VectorCode::Operation;
using Space = VectorCode::Space;

/// What an order does: with values, vectors of 4, vectors of 8 doubles. The first factor of a product is a value.
enum class Act : std::uint8_t {
    Add,
    Subtract,
    Multiply,
    MultiplyAdd,
    NegativeMultiply,
    Select,
    Move,
    Sum,    // of products
    Twice,  // a sum of two products
    Add4,
    Subtract4,
    Multiply4,
    MultiplyAdd4,
    NegativeMultiply4,
    Select4,
    Move4,
    Sum4,
    Twice4,
    Add8,
    Subtract8,
    Multiply8,
    MultiplyAdd8,
    NegativeMultiply8,
    Select8,
    Move8,
    Sum8,
    Twice8,
    Divide,
    SquareRoot,
    Absolute,
    Less,
    LessEqual,
    Equal,
    NotEqual,
    Call,
    Block,
    End
};
constexpr int actsPerWidth = 9;

/// frame[target] := act(frame[a], frame[b], frame[c]). Sum: a products from number b of the factors on, added to
/// frame[c]. Call, Block: number a.
struct Order {
    Act act{};
    std::uint32_t target{}, a{}, b{}, c{};
};

struct CallOrder {
    const void *function{}, *data{};
    std::uint32_t operands{}, at[3]{};

    double operator()(const double* frame) const {
        using One = double (*)(double);
        using Two = double (*)(double, double);
        using Three = double (*)(double, double, double);
        using Looked = double (*)(const void*, double);
        const auto address = reinterpret_cast<std::uintptr_t>(function);
        if (data) return reinterpret_cast<Looked>(address)(data, frame[at[0]]);
        if (operands == 1) return reinterpret_cast<One>(address)(frame[at[0]]);
        if (operands == 2) return reinterpret_cast<Two>(address)(frame[at[0]], frame[at[1]]);
        return reinterpret_cast<Three>(address)(frame[at[0]], frame[at[1]], frame[at[2]]);
    }
};

/// A stretch of the registers' memory and its place in the frame.
struct Mirror {
    Space space{};
    std::uint32_t offset{}, width{}, at{};
    bool isWritten{};
};

struct Orders {
    std::vector<Order> orders;
    std::vector<std::uint32_t> factors;  // of sums, in pairs
    std::vector<CallOrder> calls;
    std::vector<VectorCode::BlockCall> blocks;
    std::vector<Mirror> mirrors;
    std::uint32_t rowSize{}, rowExtent{}, rowAt{};  // an order may look at the rows that follow
    std::uint32_t resultSize{}, resultAt{};
    std::uint32_t frameSize{};
};

/// Gives every entity its place in the frame, and makes one order of each chain of products that are added up.
class OrderWriter {
public:
    explicit OrderWriter(const VectorCode& code) : code_(code) {}

    std::optional<Orders> write() {
        layOut();
        const std::vector<char> isNeeded = code_.neededSteps();
        findChains(isNeeded);
        for (std::size_t i = 0; i < isNeeded.size(); ++i)
            if (isNeeded[i] && !add(i)) return std::nullopt;
        out_.orders.push_back({Act::End, 0, 0, 0, 0});
        out_.blocks = code_.blocks();
        return std::move(out_);
    }

private:
    struct Chain {
        Entity start{VectorCode::none};
        std::vector<std::pair<Entity, Entity>> products;
    };

    void layOut() {
        out_.rowSize = code_.rowSize();
        out_.resultSize = code_.resultSize();
        out_.frameSize = static_cast<std::uint32_t>(code_.scratchSize());
        zero_ = reserve(8);
        std::map<std::pair<Space, std::uint32_t>, std::size_t> mirrorOf;
        for (const VectorCode::Home& home : code_.homes()) {
            if (home.space == Space::Row) out_.rowExtent = std::max(out_.rowExtent, home.offset + home.width);
            if (home.space != Space::Values && home.space != Space::Tangents) continue;
            const auto [at, isNew] = mirrorOf.try_emplace({home.space, home.offset}, out_.mirrors.size());
            if (isNew) out_.mirrors.push_back({home.space, home.offset, home.width, reserve(home.width), false});
        }
        out_.rowAt = reserve(out_.rowExtent);
        out_.resultAt = reserve(out_.resultSize);
        for (const VectorCode::Home& home : code_.homes())
            places_.push_back(home.space == Space::Scratch  ? home.offset
                              : home.space == Space::Row    ? out_.rowAt + home.offset
                              : home.space == Space::Result ? out_.resultAt + home.offset
                                                            : mirrorAt(mirrorOf, home).at);
        for (const VectorCode::Step& step : code_.steps()) {
            if (step.target == VectorCode::none) continue;
            const VectorCode::Home& home = code_.homes()[step.target];
            if (home.space == Space::Values || home.space == Space::Tangents) mirrorAt(mirrorOf, home).isWritten = true;
        }
    }
    Mirror& mirrorAt(const std::map<std::pair<Space, std::uint32_t>, std::size_t>& mirrorOf,
                     const VectorCode::Home& home) {
        return out_.mirrors[mirrorOf.at({home.space, home.offset})];
    }
    std::uint32_t reserve(std::uint32_t size) {
        if (size > 1) out_.frameSize = (out_.frameSize + 7) / 8 * 8;  // vectors do not straddle cache lines
        const std::uint32_t at = out_.frameSize;
        out_.frameSize += size;
        return at;
    }

    static bool isAddedProduct(Operation operation) {
        return operation == Operation::Multiply || operation == Operation::MultiplyAdd;
    }

    /// A product joins the sum it is added to when nothing else asks for it, and no register is written in between: a
    /// factor may stand there.
    void findChains(const std::vector<char>& isNeeded) {
        std::vector<int> uses(code_.homes().size(), 0);
        std::vector<std::size_t> addedAt(code_.homes().size(), 0), era(isNeeded.size(), 0);
        for (std::size_t i = 0; i < isNeeded.size(); ++i) {
            if (i > 0) era[i] = era[i - 1];
            if (!isNeeded[i]) continue;
            const VectorCode::Step& s = code_.steps()[i];
            for (const Entity e : {s.a, s.b, s.c})
                if (e != VectorCode::none) ++uses[e];
            if (s.operation == Operation::MultiplyAdd) addedAt[s.c] = i;
            if (s.operation == Operation::Block)
                for (const Entity e : code_.blocks()[s.block].reads) ++uses[e];
            const bool isRegister = s.target != VectorCode::none && code_.homes()[s.target].space != Space::Scratch;
            if (isRegister || s.operation == Operation::Block) ++era[i];
        }
        joins_.assign(isNeeded.size(), 0);
        for (std::size_t i = 0; i < isNeeded.size(); ++i) {
            const VectorCode::Step& s = code_.steps()[i];
            if (!isNeeded[i] || !isAddedProduct(s.operation) || uses[s.target] != 1) continue;
            const std::size_t to = addedAt[s.target];
            joins_[i] = to > i && era[to] == era[i] && widthOf(code_.steps()[to].target) == widthOf(s.target);
        }
    }

    int widthOf(Entity e) const { return code_.homes()[e].width; }
    std::uint32_t place(Entity e) const { return e == VectorCode::none ? 0 : places_[e]; }

    static Act actOf(Operation operation) {
        switch (operation) {
            case Operation::Add:
                return Act::Add;
            case Operation::Subtract:
                return Act::Subtract;
            case Operation::Multiply:
                return Act::Multiply;
            case Operation::MultiplyAdd:
                return Act::MultiplyAdd;
            case Operation::NegativeMultiply:
                return Act::NegativeMultiply;
            case Operation::Divide:
                return Act::Divide;
            case Operation::SquareRoot:
                return Act::SquareRoot;
            case Operation::Absolute:
                return Act::Absolute;
            case Operation::Less:
                return Act::Less;
            case Operation::LessEqual:
                return Act::LessEqual;
            case Operation::Equal:
                return Act::Equal;
            case Operation::NotEqual:
                return Act::NotEqual;
            case Operation::Select:
                return Act::Select;
            case Operation::Call:
                return Act::Call;
            case Operation::Block:
                return Act::Block;
            default:
                return Act::Move;
        }
    }

    bool add(std::size_t number) {
        VectorCode::Step s = code_.steps()[number];
        if (s.operation == Operation::Store) return true;  // everything is at its home
        Order order{actOf(s.operation), place(s.target), place(s.a), place(s.b), place(s.c)};
        if (s.operation == Operation::Block) {
            order.a = s.block;
        } else if (s.operation == Operation::Call) {
            order.a = static_cast<std::uint32_t>(out_.calls.size());
            out_.calls.push_back({s.function, s.data, 0, {}});
            CallOrder& call = out_.calls.back();
            for (const Entity e : {s.a, s.b, s.c})
                if (e != VectorCode::none) call.at[call.operands++] = place(e);
        } else {
            const int width = widthOf(s.target);
            if (width > 1 && !widen(s, order, width)) return false;
            if (isAddedProduct(s.operation)) sumUp(s, order, width, joins_[number] != 0);
            if (joins_[number]) return true;
        }
        out_.orders.push_back(order);
        return true;
    }

    /// False: vectors where none are expected.
    bool widen(VectorCode::Step& s, Order& order, int width) const {
        if (order.act > Act::Move) return false;
        const bool isProduct = isAddedProduct(s.operation) || s.operation == Operation::NegativeMultiply;
        if (isProduct && widthOf(s.a) > 1) std::swap(s.a, s.b);
        const Entity operands[] = {s.a, s.b, s.c};
        for (int k = 0; k < 3; ++k) {
            const bool isValue = k == 0 && (isProduct || s.operation == Operation::Select);
            if (operands[k] != VectorCode::none && widthOf(operands[k]) != (isValue ? 1 : width)) return false;
        }
        order.a = place(s.a), order.b = place(s.b);
        order.act = ofWidth(order.act, width);
        return true;
    }
    static Act ofWidth(Act act, int width) {
        return static_cast<Act>(static_cast<int>(act) + actsPerWidth * (width == 8 ? 2 : width == 4 ? 1 : 0));
    }

    void sumUp(const VectorCode::Step& s, Order& order, int width, bool joins) {
        Chain chain{s.c, {}};
        if (const auto before = chains_.find(s.c); before != chains_.end()) chain = std::move(before->second);
        chain.products.emplace_back(s.a, s.b);
        if (joins) {
            chains_[s.target] = std::move(chain);
        } else if (chain.products.size() > 1) {
            order = {ofWidth(chain.products.size() == 2 ? Act::Twice : Act::Sum, width), order.target,
                     static_cast<std::uint32_t>(chain.products.size()), static_cast<std::uint32_t>(out_.factors.size()),
                     chain.start == VectorCode::none ? zero_ : place(chain.start)};
            for (const auto& [a, b] : chain.products) {
                out_.factors.push_back(place(a));
                out_.factors.push_back(place(b));
            }
        }
    }

    const VectorCode& code_;
    Orders out_;
    std::vector<std::uint32_t> places_;  // by entity
    std::vector<char> joins_;            // by step: its product is part of a later sum
    std::map<Entity, Chain> chains_;     // of what joins
    std::uint32_t zero_{};
};

/// What the orders of a run see of the world outside.
struct Outside {
    double* values{};
    double* tangents{};
    Registers* registers{};

    double* at(const Mirror& mirror) const {
        return (mirror.space == Space::Values ? values : tangents) + mirror.offset;
    }
    void fetch(const Orders& code, double* frame) const {
        for (const Mirror& mirror : code.mirrors) std::copy_n(at(mirror), mirror.width, frame + mirror.at);
    }
    void hand(const Orders& code, const double* frame) const {
        for (const Mirror& mirror : code.mirrors)
            if (mirror.isWritten) std::copy_n(frame + mirror.at, mirror.width, at(mirror));
    }
    bool solve(const Orders& code, const Order& order, double* frame) const {
        hand(code, frame);
        const VectorCode::BlockCall& block = code.blocks[order.a];
        if (!block.function(registers, block.data)) return false;
        fetch(code, frame);
        return true;
    }
};

#define INLINE [[gnu::always_inline]] inline

/// L doubles that the processor takes at once.
template <int L>
struct Piece {
    typedef double Type __attribute__((vector_size(L * 8), aligned(8), may_alias));
};
template <>
struct Piece<1> {
    using Type = double;
};
template <int L>
INLINE typename Piece<L>::Type& piece(double* at) {
    return *reinterpret_cast<typename Piece<L>::Type*>(at);
}

// On W doubles, L at once.

template <int L, int W>
INLINE void add(const Order& o, double* f) {
    for (int k = 0; k < W; k += L) piece<L>(f + o.target + k) = piece<L>(f + o.a + k) + piece<L>(f + o.b + k);
}
template <int L, int W>
INLINE void subtract(const Order& o, double* f) {
    for (int k = 0; k < W; k += L) piece<L>(f + o.target + k) = piece<L>(f + o.a + k) - piece<L>(f + o.b + k);
}
template <int L, int W>
INLINE void multiply(const Order& o, double* f) {
    const double a = f[o.a];
    for (int k = 0; k < W; k += L) piece<L>(f + o.target + k) = a * piece<L>(f + o.b + k);
}
template <int L, int W>
INLINE void multiplyAdd(const Order& o, double* f) {
    const double a = f[o.a];
    for (int k = 0; k < W; k += L) piece<L>(f + o.target + k) = a * piece<L>(f + o.b + k) + piece<L>(f + o.c + k);
}
template <int L, int W>
INLINE void negativeMultiply(const Order& o, double* f) {
    const double a = f[o.a];
    for (int k = 0; k < W; k += L) piece<L>(f + o.target + k) = piece<L>(f + o.c + k) - a * piece<L>(f + o.b + k);
}
template <int L, int W>
INLINE void move(double* f, std::uint32_t target, std::uint32_t from) {
    for (int k = 0; k < W; k += L) piece<L>(f + target + k) = piece<L>(f + from + k);
}
template <int L, int W>
INLINE void sum(const Order& o, const std::uint32_t* factors, double* f) {
    const std::uint32_t* const begin = factors + o.b;
    const std::uint32_t* const end = begin + 2 * o.a;
    constexpr int second = W > L ? L : 0;  // two pieces a walk over the factors
    for (int k = 0; k < W; k += 2 * L) {
        auto low = piece<L>(f + o.c + k), high = piece<L>(f + o.c + k + second);
        for (const std::uint32_t* p = begin; p != end; p += 2) {
            const double factor = f[p[0]];
            low += factor * piece<L>(f + p[1] + k);
            if (second > 0) high += factor * piece<L>(f + p[1] + k + second);
        }
        piece<L>(f + o.target + k) = low;
        if (second > 0) piece<L>(f + o.target + k + second) = high;
    }
}

template <int L, int W>
INLINE void twice(const Order& o, const std::uint32_t* factors, double* f) {
    const std::uint32_t* const p = factors + o.b;
    const double first = f[p[0]], second = f[p[2]];
    for (int k = 0; k < W; k += L)
        piece<L>(f + o.target + k) =
            piece<L>(f + o.c + k) + first * piece<L>(f + p[1] + k) + second * piece<L>(f + p[3] + k);
}

// One jump for each order, at the end of the one before: the processor learns what follows what (Ertl & Gregg, Journal
// of Instruction-Level Parallelism 5 (2003)). A function with such jumps is not inlined, so it is written out once for
// each instruction set. Rows go in, results go out.
#define ACT(name, ...)          \
    name : {                    \
        const Order& o = *at++; \
        __VA_ARGS__;            \
    }                           \
    goto* acts[static_cast<std::size_t>(at->act)];
#define WALK(name, L)                                                                                     \
    bool name(const Orders& code, const Outside& outside, double* f, const double* rows, double* results, \
              std::int64_t count) {                                                                       \
        static const void* const acts[] = {&&Add,                                                         \
                                           &&Subtract,                                                    \
                                           &&Multiply,                                                    \
                                           &&MultiplyAdd,                                                 \
                                           &&NegativeMultiply,                                            \
                                           &&Select,                                                      \
                                           &&Move,                                                        \
                                           &&Sum,                                                         \
                                           &&Twice,                                                       \
                                           &&Add4,                                                        \
                                           &&Subtract4,                                                   \
                                           &&Multiply4,                                                   \
                                           &&MultiplyAdd4,                                                \
                                           &&NegativeMultiply4,                                           \
                                           &&Select4,                                                     \
                                           &&Move4,                                                       \
                                           &&Sum4,                                                        \
                                           &&Twice4,                                                      \
                                           &&Add8,                                                        \
                                           &&Subtract8,                                                   \
                                           &&Multiply8,                                                   \
                                           &&MultiplyAdd8,                                                \
                                           &&NegativeMultiply8,                                           \
                                           &&Select8,                                                     \
                                           &&Move8,                                                       \
                                           &&Sum8,                                                        \
                                           &&Twice8,                                                      \
                                           &&Divide,                                                      \
                                           &&SquareRoot,                                                  \
                                           &&Absolute,                                                    \
                                           &&Less,                                                        \
                                           &&LessEqual,                                                   \
                                           &&Equal,                                                       \
                                           &&NotEqual,                                                    \
                                           &&Call,                                                        \
                                           &&Block,                                                       \
                                           &&End};                                                        \
        const std::uint32_t* const factors = code.factors.data();                                         \
        for (;;) {                                                                                        \
            for (std::uint32_t i = 0; i < code.rowExtent; ++i) f[code.rowAt + i] = rows[i];               \
            const Order* at = code.orders.data();                                                         \
            goto* acts[static_cast<std::size_t>(at->act)];                                                \
            ACT(Add, add<1, 1>(o, f))                                                                     \
            ACT(Subtract, subtract<1, 1>(o, f))                                                           \
            ACT(Multiply, multiply<1, 1>(o, f))                                                           \
            ACT(MultiplyAdd, multiplyAdd<1, 1>(o, f))                                                     \
            ACT(NegativeMultiply, negativeMultiply<1, 1>(o, f))                                           \
            ACT(Select, f[o.target] = f[o.a] != 0 ? f[o.b] : f[o.c])                                      \
            ACT(Move, f[o.target] = f[o.a])                                                               \
            ACT(Sum, sum<1, 1>(o, factors, f))                                                            \
            ACT(Twice, twice<1, 1>(o, factors, f))                                                        \
            ACT(Add4, add<L, 4>(o, f))                                                                    \
            ACT(Subtract4, subtract<L, 4>(o, f))                                                          \
            ACT(Multiply4, multiply<L, 4>(o, f))                                                          \
            ACT(MultiplyAdd4, multiplyAdd<L, 4>(o, f))                                                    \
            ACT(NegativeMultiply4, negativeMultiply<L, 4>(o, f))                                          \
            ACT(Select4, move<L, 4>(f, o.target, f[o.a] != 0 ? o.b : o.c))                                \
            ACT(Move4, move<L, 4>(f, o.target, o.a))                                                      \
            ACT(Sum4, sum<L, 4>(o, factors, f))                                                           \
            ACT(Twice4, twice<L, 4>(o, factors, f))                                                       \
            ACT(Add8, add<L, 8>(o, f))                                                                    \
            ACT(Subtract8, subtract<L, 8>(o, f))                                                          \
            ACT(Multiply8, multiply<L, 8>(o, f))                                                          \
            ACT(MultiplyAdd8, multiplyAdd<L, 8>(o, f))                                                    \
            ACT(NegativeMultiply8, negativeMultiply<L, 8>(o, f))                                          \
            ACT(Select8, move<L, 8>(f, o.target, f[o.a] != 0 ? o.b : o.c))                                \
            ACT(Move8, move<L, 8>(f, o.target, o.a))                                                      \
            ACT(Sum8, sum<L, 8>(o, factors, f))                                                           \
            ACT(Twice8, twice<L, 8>(o, factors, f))                                                       \
            ACT(Divide, f[o.target] = f[o.a] / f[o.b])                                                    \
            ACT(SquareRoot, f[o.target] = std::sqrt(f[o.a]))                                              \
            ACT(Absolute, f[o.target] = std::fabs(f[o.a]))                                                \
            ACT(Less, f[o.target] = f[o.a] < f[o.b])                                                      \
            ACT(LessEqual, f[o.target] = f[o.a] <= f[o.b])                                                \
            ACT(Equal, f[o.target] = f[o.a] == f[o.b])                                                    \
            ACT(NotEqual, f[o.target] = f[o.a] != f[o.b])                                                 \
            ACT(Call, f[o.target] = code.calls[o.a](f))                                                   \
            ACT(Block, if (!outside.solve(code, o, f)) return false)                                      \
        End:                                                                                              \
            for (std::uint32_t i = 0; i < code.resultSize; ++i) *results++ = f[code.resultAt + i];        \
            if (--count <= 0) return true;                                                                \
            rows += code.rowSize;                                                                         \
        }                                                                                                 \
    }

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
WALK(walkPlain, 2)
#if defined(__x86_64__) && defined(__GNUC__)
// Wider vectors where the processor has them; without fused operations, so that results are the same everywhere.
[[gnu::target("avx2")]] WALK(walkWide, 4) bool hasWideVectors() { return __builtin_cpu_supports("avx2"); }
#else
constexpr auto walkWide = walkPlain;
bool hasWideVectors() { return false; }
#endif
#pragma GCC diagnostic pop
#undef WALK
#undef ACT
#undef INLINE

/// All in one frame: the scratch memory, what the code knows of the registers, the row at hand and its result.
class VectorInterpreter final : public VectorFunction {
public:
    explicit VectorInterpreter(Orders code) : code_(std::move(code)) {}

    std::size_t scratchSize() const override { return code_.frameSize; }

    bool run(double* values, double* tangents, double* scratch, Registers* registers, const double* rows,
             double* results, std::int64_t count) const override {
        static const auto walks = hasWideVectors() ? walkWide : walkPlain;
        const Outside outside{values, tangents, registers};
        outside.fetch(code_, scratch);
        if (!walks(code_, outside, scratch, rows, results, count)) return false;
        outside.hand(code_, scratch);
        return true;
    }

private:
    Orders code_;
};

}  // namespace

std::unique_ptr<const VectorFunction> interpret(const VectorCode& code) {
    std::optional<Orders> orders = OrderWriter(code).write();
    if (!orders) return nullptr;
    return std::make_unique<VectorInterpreter>(std::move(*orders));
}

}  // namespace analogon
