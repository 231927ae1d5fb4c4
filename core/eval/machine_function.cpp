#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

#include "core/eval/vector_code.hpp"

#if defined(ANALOGON_HAS_ASMJIT) && defined(__x86_64__) && !defined(_WIN32)
#include <asmjit/x86.h>

namespace analogon {
namespace {

namespace x86 = asmjit::x86;
using Entity = VectorCode::Entity;
using Operation = VectorCode::Operation;

struct Processor {
    bool hasAvx2{}, hasAvx512{};
    Processor() {
        const auto& features = asmjit::CpuInfo::host().features().x86();
        hasAvx2 = features.hasAVX2() && features.hasFMA();
        const char* const asked = std::getenv("ANALOGON_VECTOR_WIDTH");
        const bool mayBeWide = !asked || std::strcmp(asked, "4") != 0;
        hasAvx512 =
            hasAvx2 && mayBeWide && features.hasAVX512_F() && features.hasAVX512_DQ() && features.hasAVX512_VL();
    }
};
const Processor& processor() {
    static const Processor here;
    return here;
}

/// Translates in one pass. Registers are given out on demand; the one whose content is needed last makes room (Belady
/// 1966), which straight-line code lets us know.
class Translator {
public:
    Translator(const VectorCode& code, x86::Assembler& out, bool isWide)
        : code_(code), out_(out), isWide_(isWide), count_(isWide ? 32 : 16) {
        const std::size_t entities = code.homes().size();
        at_.assign(entities, -1);
        uses_.resize(entities);
        nextUse_.assign(entities, 0);
        for (std::size_t i = 0; i < entities; ++i) {
            isStored_.push_back(code.homes()[i].isInMemory);
            valueWidth_ = std::max<int>(valueWidth_, code.homes()[i].width);
        }
        isSpread_.assign(entities, false);
        holds_.fill(VectorCode::none);
    }

    void run() {
        collectUses();
        fail_ = out_.newLabel();
        prologue();
        const asmjit::Label next = out_.newLabel();
        out_.bind(next);
        for (now_ = 0; now_ < code_.steps().size(); ++now_)
            if (isLive_[now_]) step(code_.steps()[now_]);
        if (code_.isLoop()) {
            out_.add(x86::r14, 8 * code_.rowSize());
            if (code_.resultSize() > 0) out_.add(x86::r15, 8 * code_.resultSize());
            out_.dec(x86::qword_ptr(x86::rsp, countAt_));
            out_.jnz(next);
        }
        out_.mov(x86::eax, 1);
        epilogue();
        out_.bind(fail_);
        out_.xor_(x86::eax, x86::eax);
        epilogue();
    }

private:
    static constexpr int first_ = 3;     // registers 0 to 2 carry arguments and intermediate values
    static constexpr int countAt_ = 64;  // on the stack: the seventh argument, above what a loop keeps

    void collectUses() {
        const auto use = [&](Entity e, std::size_t i) {
            if (e != VectorCode::none) uses_[e].push_back(static_cast<std::uint32_t>(i));
        };
        isLive_ = code_.neededSteps();
        for (std::size_t i = 0; i < code_.steps().size(); ++i) {
            if (!isLive_[i]) continue;
            const VectorCode::Step& s = code_.steps()[i];
            use(s.a, i), use(s.b, i), use(s.c, i);
            if (s.operation == Operation::Block)
                for (const Entity e : code_.blocks()[s.block].reads) use(e, i);
        }
    }

    void prologue() {
        out_.push(x86::rbx);
        out_.push(x86::rbp);
        out_.push(x86::r12);
        out_.push(x86::r13);
        if (code_.isLoop()) {
            out_.push(x86::r14);
            out_.push(x86::r15);
            out_.mov(x86::r14, x86::r8);
            out_.mov(x86::r15, x86::r9);
        }
        out_.sub(x86::rsp, 8);
        out_.mov(x86::rbx, x86::rdi);
        out_.mov(x86::r12, x86::rsi);
        out_.mov(x86::r13, x86::rdx);
        out_.mov(x86::rbp, x86::rcx);
    }
    void epilogue() {
        out_.vzeroupper();
        out_.add(x86::rsp, 8);
        if (code_.isLoop()) {
            out_.pop(x86::r15);
            out_.pop(x86::r14);
        }
        out_.pop(x86::r13);
        out_.pop(x86::r12);
        out_.pop(x86::rbp);
        out_.pop(x86::rbx);
        out_.ret();
    }

    int widthOf(Entity e) const { return code_.homes()[e].width; }
    /// The register as wide as an operation asks for; that of a value as wide as the widest here.
    x86::Vec reg(int number, int width) const {
        const auto id = static_cast<std::uint32_t>(number);
        if (width == 1) width = valueWidth_;
        if (width == 8) return x86::Zmm(id);
        if (width == 4) return x86::Ymm(id);
        return x86::Xmm(id);
    }
    x86::Mem home(Entity e) const {
        const VectorCode::Home& h = code_.homes()[e];
        const x86::Gp bases[] = {x86::rbx, x86::r12, x86::r13, x86::r14, x86::r15};
        return x86::ptr(bases[static_cast<std::size_t>(h.space)], static_cast<std::int32_t>(8 * h.offset));
    }

    /// Step of the next use after the one under way; beyond the end: none.
    std::size_t nextUse(Entity e) {
        std::uint32_t& cursor = nextUse_[e];
        while (cursor < uses_[e].size() && uses_[e][cursor] <= now_) ++cursor;
        return cursor < uses_[e].size() ? uses_[e][cursor] : code_.steps().size();
    }
    bool isNeededLater(Entity e) { return nextUse(e) < code_.steps().size(); }

    void storeHome(Entity e) {
        if (isStored_[e]) return;
        const int r = at_[e];
        if (widthOf(e) == 1) {
            out_.vmovsd(home(e), x86::Xmm(static_cast<std::uint32_t>(r)));
        } else {
            out_.vmovupd(home(e), reg(r, widthOf(e)));
        }
        isStored_[e] = true;
    }

    void release(int r) {
        if (holds_[index(r)] != VectorCode::none) at_[holds_[index(r)]] = -1;
        holds_[index(r)] = VectorCode::none;
    }
    static std::size_t index(int r) { return static_cast<std::size_t>(r); }

    int take() {
        int best = -1;
        std::size_t farthest = 0;
        for (int r = first_; r < count_; ++r) {
            const Entity e = holds_[index(r)];
            if (e == VectorCode::none && !isPinned_[index(r)]) return r;
            if (isPinned_[index(r)]) continue;
            std::size_t use = nextUse(e);
            // What is in memory already leaves for nothing.
            if (isStored_[e]) use += 2;
            if (best < 0 || use > farthest) best = r, farthest = use;
        }
        const Entity e = holds_[index(best)];
        if (isNeededLater(e)) storeHome(e);
        release(best);
        return best;
    }
    void give(int r, Entity e) {
        release(r);
        holds_[index(r)] = e;
        at_[e] = r;
    }
    void pin(int r) { isPinned_[index(r)] = true; }

    void loadInto(int r, Entity e, int width) {
        if (widthOf(e) == 1 && valueWidth_ == 1) {
            out_.vmovsd(low(r), home(e));
        } else if (widthOf(e) == 1) {
            out_.vbroadcastsd(reg(r, width), home(e));
        } else {
            out_.vmovupd(reg(r, width), home(e));
        }
    }

    /// A register that holds the entity, for an operation of this width; pinned for this step. A value that comes from
    /// a scalar operation stands in the first place alone, and is spread once vectors ask for it: operations on values
    /// do not wait for that.
    int inRegister(Entity e, int width = 1) {
        if (at_[e] < 0) {
            const int r = take();
            loadInto(r, e, widthOf(e));
            give(r, e);
            isSpread_[e] = true;
        }
        pin(at_[e]);
        if (width > 1 && widthOf(e) == 1 && !isSpread_[e]) {
            spread(at_[e]);
            isSpread_[e] = true;
        }
        return at_[e];
    }

    /// As the last operand of an instruction of this width: straight from memory when that is its last use.
    struct Source {
        bool isMemory{};
        x86::Mem memory;
        int number{};
    };
    Source source(Entity e, int width) {
        if (at_[e] >= 0 || isNeededLater(e) || (widthOf(e) == 1 && !isWide_)) return {false, {}, inRegister(e, width)};
        return {true, home(e), 0};
    }
    x86::Mem memoryAs(const Source& s, Entity e, int width) const {
        if (widthOf(e) != 1) return s.memory;
        if (width == 1) width = valueWidth_;
        return width == 8 ? s.memory._1to8() : width == 4 ? s.memory._1to4() : s.memory._1to2();
    }

    /// A register for the result; that of an operand whose last use this is, where the instruction allows it.
    int target(Entity e, std::initializer_list<Entity> mayReplace) {
        for (const Entity old : mayReplace)
            if (old != VectorCode::none && at_[old] >= 0 && !isNeededLater(old)) {
                const int r = at_[old];
                give(r, e);
                return r;
            }
        const int r = take();
        give(r, e);
        return r;
    }

    template <class Emit>
    void binary(const VectorCode::Step& s, Emit&& emit) {
        const int width = widthOf(s.target);
        const int a = inRegister(s.a, width);
        const Source b = source(s.b, width);
        const int d = target(s.target, {s.a, s.b});
        if (b.isMemory) {
            emit(reg(d, width), reg(a, width), memoryAs(b, s.b, width));
        } else {
            emit(reg(d, width), reg(a, width), reg(b.number, width));
        }
    }

    void multiplyAdd(const VectorCode::Step& s) {
        const bool isNegative = s.operation == Operation::NegativeMultiply;
        const int width = widthOf(s.target);
        const int a = inRegister(s.a, width);
        const Source b = source(s.b, width);
        int d;
        if (at_[s.c] >= 0 && !isNeededLater(s.c) && s.c != s.a && s.c != s.b) {
            d = at_[s.c];
            give(d, s.target);
        } else if (at_[s.c] >= 0) {
            pin(at_[s.c]);
            d = take();
            out_.vmovapd(reg(d, width), reg(at_[s.c], width));
            give(d, s.target);
        } else {
            d = take();
            loadInto(d, s.c, width);
            give(d, s.target);
        }
        const auto emit = [&](const auto& operand) {
            if (isNegative) {
                out_.vfnmadd231pd(reg(d, width), reg(a, width), operand);
            } else {
                out_.vfmadd231pd(reg(d, width), reg(a, width), operand);
            }
        };
        if (b.isMemory) {
            emit(memoryAs(b, s.b, width));
        } else {
            emit(reg(b.number, width));
        }
    }

    x86::Xmm low(int r) const { return x86::Xmm(static_cast<std::uint32_t>(r)); }
    /// The first place to all of them.
    void spread(int r) {
        if (valueWidth_ > 1) out_.vbroadcastsd(reg(r, 1), low(r));
    }

    void scalar(const VectorCode::Step& s) {
        const int a = inRegister(s.a);
        const int b = s.operation == Operation::Divide ? inRegister(s.b) : a;
        const int d = target(s.target, {s.a, s.b});
        if (s.operation == Operation::Divide) {
            out_.vdivsd(low(d), low(a), low(b));
        } else {
            out_.vsqrtsd(low(d), low(a), low(a));
        }
    }

    /// Whether the result of operations on these values fills its register.
    bool isSpreadAfter(const VectorCode::Step& s) const {
        if (s.operation == Operation::Divide || s.operation == Operation::SquareRoot || s.operation == Operation::Call)
            return false;
        for (const Entity e : {s.a, s.b, s.c})
            if (e != VectorCode::none && at_[e] >= 0 && !isSpread_[e]) return false;
        return true;
    }

    void constantInto(int r, double value) {
        std::uint64_t bits;
        static_assert(sizeof bits == sizeof value);
        __builtin_memcpy(&bits, &value, sizeof bits);
        out_.mov(x86::rax, bits);
        out_.vmovq(x86::Xmm(static_cast<std::uint32_t>(r)), x86::rax);
        spread(r);
    }

    void compare(const VectorCode::Step& s) {
        const int a = inRegister(s.a), b = inRegister(s.b);
        const int predicate = s.operation == Operation::Less        ? 17
                              : s.operation == Operation::LessEqual ? 18
                              : s.operation == Operation::Equal     ? 0
                                                                    : 4;
        constantInto(0, 1.0);
        const int d = target(s.target, {});
        if (isWide_) {
            out_.vcmppd(x86::k1, reg(a, 1), reg(b, 1), predicate);
            out_.k(x86::k1).z().vmovapd(reg(d, 1), reg(0, 1));
        } else {
            out_.vcmppd(reg(d, 1), reg(a, 1), reg(b, 1), predicate);
            out_.vandpd(reg(d, 1), reg(d, 1), reg(0, 1));
        }
    }

    void select(const VectorCode::Step& s) {
        const int width = widthOf(s.target);
        const int a = inRegister(s.a, width), b = inRegister(s.b, width), c = inRegister(s.c, width);
        const int d = target(s.target, {});
        out_.vxorpd(x86::xmm0, x86::xmm0, x86::xmm0);
        if (isWide_) {
            out_.vcmppd(x86::k1, reg(a, width), reg(0, width), 4);
            out_.k(x86::k1).vblendmpd(reg(d, width), reg(c, width), reg(b, width));
        } else {
            out_.vcmppd(reg(0, width), reg(a, width), reg(0, width), 4);
            out_.vblendvpd(reg(d, width), reg(c, width), reg(b, width), reg(0, width));
        }
    }

    void absolute(const VectorCode::Step& s) {
        const int a = inRegister(s.a);
        out_.mov(x86::rax, 0x7fffffffffffffffull);
        out_.vmovq(x86::xmm0, x86::rax);
        spread(0);
        const int d = target(s.target, {s.a});
        out_.vandpd(reg(d, 1), reg(a, 1), reg(0, 1));
    }

    void move(const VectorCode::Step& s) {
        const int width = widthOf(s.target);
        const int d = take();
        pin(d);
        if (at_[s.a] >= 0) {
            out_.vmovapd(reg(d, width), reg(at_[s.a], width));
        } else {
            loadInto(d, s.a, width);
        }
        give(d, s.target);
    }

    /// Calls may use every vector register.
    void clear() {
        for (int r = first_; r < count_; ++r) {
            const Entity e = holds_[index(r)];
            if (e == VectorCode::none) continue;
            if (isNeededLater(e)) storeHome(e);
            release(r);
        }
        out_.vzeroupper();
    }

    void call(const VectorCode::Step& s) {
        const Entity operands[] = {s.a, s.b, s.c};
        for (int i = 0; i < 3; ++i) {
            const Entity e = operands[i];
            if (e == VectorCode::none) continue;
            if (at_[e] >= 0) {
                out_.vmovapd(x86::Xmm(static_cast<std::uint32_t>(i)), low(at_[e]));
            } else {
                out_.vmovsd(x86::Xmm(static_cast<std::uint32_t>(i)), home(e));
            }
        }
        isPinned_.fill(false);
        clear();
        if (s.data) out_.mov(x86::rdi, reinterpret_cast<std::uint64_t>(s.data));
        out_.mov(x86::rax, reinterpret_cast<std::uint64_t>(s.function));
        out_.call(x86::rax);
        const int d = take();
        out_.vmovapd(low(d), x86::xmm0);
        give(d, s.target);
    }

    void block(const VectorCode::Step& s) {
        const VectorCode::BlockCall& b = code_.blocks()[s.block];
        for (const Entity e : b.reads)
            if (at_[e] >= 0) storeHome(e);
        clear();
        out_.mov(x86::rdi, x86::rbp);
        out_.mov(x86::rsi, reinterpret_cast<std::uint64_t>(b.data));
        out_.mov(x86::rax, reinterpret_cast<std::uint64_t>(b.function));
        out_.call(x86::rax);
        out_.test(x86::al, x86::al);
        out_.jz(fail_);
    }

    void step(const VectorCode::Step& s) {
        isPinned_.fill(false);
        for (const Entity e : {s.a, s.b, s.c})
            if (e != VectorCode::none && at_[e] >= 0) pin(at_[e]);
        const bool isSpread = isSpreadAfter(s);
        switch (s.operation) {
            case Operation::Add:
                binary(s, [&](auto d, auto a, auto b) { out_.vaddpd(d, a, b); });
                break;
            case Operation::Subtract:
                binary(s, [&](auto d, auto a, auto b) { out_.vsubpd(d, a, b); });
                break;
            case Operation::Multiply:
                binary(s, [&](auto d, auto a, auto b) { out_.vmulpd(d, a, b); });
                break;
            case Operation::MultiplyAdd:
            case Operation::NegativeMultiply:
                multiplyAdd(s);
                break;
            case Operation::Divide:
            case Operation::SquareRoot:
                scalar(s);
                break;
            case Operation::Absolute:
                absolute(s);
                break;
            case Operation::Less:
            case Operation::LessEqual:
            case Operation::Equal:
            case Operation::NotEqual:
                compare(s);
                break;
            case Operation::Select:
                select(s);
                break;
            case Operation::Move:
                move(s);
                break;
            case Operation::Store:
                if (!isStored_[s.a]) storeHome(s.a);
                break;
            case Operation::Call:
                call(s);
                break;
            case Operation::Block:
                block(s);
                break;
        }
        if (s.target != VectorCode::none) isSpread_[s.target] = isSpread;
        const Entity touched[] = {s.a, s.b, s.c, s.target};
        for (const Entity e : touched)
            if (e != VectorCode::none && at_[e] >= 0 && !isNeededLater(e)) release(at_[e]);
    }

    const VectorCode& code_;
    x86::Assembler& out_;
    bool isWide_{};
    int count_{}, valueWidth_{1};
    std::size_t now_{};
    std::vector<char> isLive_;
    asmjit::Label fail_;
    std::vector<int> at_;
    std::vector<char> isStored_;
    std::vector<char> isSpread_;  // of values in registers
    std::vector<std::vector<std::uint32_t>> uses_;
    std::vector<std::uint32_t> nextUse_;  // cursor in uses_
    std::array<Entity, 32> holds_{};
    std::array<bool, 32> isPinned_{};
};

/// The first fault makes the whole translation void.
class FaultKeeper final : public asmjit::ErrorHandler {
public:
    void handleError(asmjit::Error, const char*, asmjit::BaseEmitter*) override { hasFailed = true; }
    bool hasFailed{};
};

using Function = int (*)(double*, double*, double*, Registers*, const double*, double*, std::int64_t);

/// Each function keeps its own pages: systems come and go with their candidates.
class MachineFunction final : public VectorFunction {
public:
    static std::unique_ptr<const VectorFunction> make(const VectorCode& code, bool isWide) {
        auto made = std::make_unique<MachineFunction>();
        asmjit::CodeHolder holder;
        if (holder.init(made->runtime_.environment()) != asmjit::kErrorOk) return nullptr;
        FaultKeeper faults;
        holder.setErrorHandler(&faults);
        x86::Assembler out(&holder);
        Translator(code, out, isWide).run();
        if (faults.hasFailed || made->runtime_.add(&made->function_, &holder) != asmjit::kErrorOk) return nullptr;
        made->scratchSize_ = code.scratchSize();
        return made;
    }
    std::size_t scratchSize() const override { return scratchSize_; }
    bool run(double* values, double* tangents, double* scratch, Registers* registers, const double* rows,
             double* results, std::int64_t count) const override {
        return function_(values, tangents, scratch, registers, rows, results, count) != 0;
    }

private:
    asmjit::JitRuntime runtime_;
    Function function_{};
    std::size_t scratchSize_{};
};

}  // namespace

VectorTarget VectorCode::fastest() {
    if (!processor().hasAvx2) return VectorTarget::Interpreter;
    return processor().hasAvx512 ? VectorTarget::Avx512 : VectorTarget::Avx2;
}

std::unique_ptr<const VectorFunction> translate(const VectorCode& code, VectorTarget target) {
    const VectorTarget best = VectorCode::fastest();
    if (target == VectorTarget::Interpreter || best < target) return nullptr;
    return MachineFunction::make(code, target == VectorTarget::Avx512);
}

}  // namespace analogon

#else

namespace analogon {

VectorTarget VectorCode::fastest() { return VectorTarget::Interpreter; }
std::unique_ptr<const VectorFunction> translate(const VectorCode&, VectorTarget) { return nullptr; }

}  // namespace analogon

#endif
