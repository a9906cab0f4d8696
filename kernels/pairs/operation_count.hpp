// How many arithmetic operations a pass needs per pair, counted by running its loop on numbers that only remember how
// they came about: so the count follows the formula.
//
// Counted once per lane of a row: every distinct addition, multiplication, maximum and minimum that depends on the
// candidate (what depends on the particle itself alone is computed once per row), and the addition to the sum. A
// multiplication and an addition that the processor fuses are two. A change of sign is free. A reciprocal is 4 and an
// inverse square root 6, an estimate and one step of Newton's, whatever the level does: figures of one pass can then be
// compared across precisions and instruction sets. Particles have one and the same smoothing length; where they have
// not, a pair takes some more.
//
// Only for files that are compiled for the level `counted` (kernels/CMakeLists.txt), which has loops on Symbols in
// place of those on numbers.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "kernels/pairs/block_loop_body.hpp"

namespace sluice::counted {

/// Expressions seen so far, each once.
class Ledger {
  public:
    enum class Kind { fixed, varying, add, multiply, larger, smaller, negate, reciprocal, inverse_sqrt };

    /// Same kind and operands, same number. 0 is the constant 0.
    std::uint32_t intern(Kind kind, std::uint32_t a, std::uint32_t b = 0) {
        if ((kind == Kind::add || kind == Kind::multiply) && b < a) std::swap(a, b);
        const bool varies = entries_[a].varies || entries_[b].varies;
        const auto [place, is_new] = known_.try_emplace({kind, a, b}, next());
        if (is_new) entries_.push_back({kind, a, b, varies});
        return place->second;
    }
    std::uint32_t constant(double value) {
        if (value == 0) return 0;
        const auto [place, is_new] = constants_.try_emplace(value, next());
        if (is_new) entries_.push_back({});
        return place->second;
    }
    /// A number read from memory, of a candidate (varying) or of the particle itself (fixed): new each time.
    std::uint32_t loaded(Kind kind) {
        entries_.push_back({kind, 0, 0, kind == Kind::varying});
        return next() - 1;
    }
    /// The expression is a result: what it is made of is counted, unless it has been before.
    void use(std::uint32_t id) {
        Entry& e = entries_[id];
        if (e.is_used || !e.varies) return;
        e.is_used = true;
        operations_ += cost(e.kind);
        use(e.a);
        use(e.b);
    }
    std::uint64_t operations() const { return operations_; }

    static Ledger& current() {
        static Ledger ledger;
        return ledger;
    }

  private:
    struct Entry {
        Kind kind = Kind::fixed;
        std::uint32_t a = 0, b = 0;
        bool varies = false, is_used = false;
    };

    std::uint32_t next() const { return static_cast<std::uint32_t>(entries_.size()); }
    static unsigned cost(Kind kind) {
        switch (kind) {
            case Kind::fixed:
            case Kind::varying:
            case Kind::negate:
                return 0;
            case Kind::reciprocal:
                return 4;
            case Kind::inverse_sqrt:
                return 6;
            case Kind::add:
            case Kind::multiply:
            case Kind::larger:
            case Kind::smaller:
                break;
        }
        return 1;
    }

    std::map<std::tuple<Kind, std::uint32_t, std::uint32_t>, std::uint32_t> known_;
    std::map<double, std::uint32_t> constants_;
    std::vector<Entry> entries_{Entry{}};
    std::uint64_t operations_ = 0;
};

/// A number that is known by its place in the ledger. Not inlined: loops on it are long enough to compile as it is.
struct Symbol {
    std::uint32_t id = 0;

    Symbol() = default;
    [[gnu::noinline]] Symbol(double value) : id(Ledger::current().constant(value)) {}
    /// Done with results only.
    [[gnu::noinline]] explicit operator double() const {
        Ledger::current().use(id);
        return 0;
    }

    /// The only lane of a register.
    Symbol operator[](int) const { return *this; }

    using Kind = Ledger::Kind;
    static Symbol numbered(std::uint32_t id) {
        Symbol s;
        s.id = id;
        return s;
    }
    [[gnu::noinline]] static Symbol of(Kind kind, Symbol a) { return numbered(Ledger::current().intern(kind, a.id)); }
    [[gnu::noinline]] static Symbol of(Kind kind, Symbol a, Symbol b) {
        return numbered(Ledger::current().intern(kind, a.id, b.id));
    }
    [[gnu::noinline]] static Symbol loaded(Kind kind) { return numbered(Ledger::current().loaded(kind)); }
    friend Symbol operator+(Symbol a, Symbol b) { return of(Kind::add, a, b); }
    friend Symbol operator*(Symbol a, Symbol b) { return of(Kind::multiply, a, b); }
    Symbol& operator+=(Symbol b) { return *this = *this + b; }
};

template <>
inline constexpr int widest<Symbol> = 1;

/// A register of one lane.
template <>
struct Pack<Symbol, 1> {
    using Number = Symbol;
    using Kind = Symbol::Kind;
    static constexpr int lanes = 1, along_j = 1, along_i = 1;

    Symbol v;

    Pack() = default;
    Pack(Symbol a) : v(a) {}
    explicit Pack(double s) : v(s) {}

    Pack& operator+=(Pack b) { return *this = *this + b; }
    Pack& operator-=(Pack b) { return *this = *this - b; }
    Pack& operator*=(Pack b) { return *this = *this * b; }
    friend Pack operator+(Pack a, Pack b) { return a.v + b.v; }
    friend Pack operator-(Pack a) { return Symbol::of(Kind::negate, a.v); }
    friend Pack operator-(Pack a, Pack b) { return a + -b; }
    friend Pack operator*(Pack a, Pack b) { return a.v * b.v; }
    friend Pack larger(Pack a, Pack b) { return Symbol::of(Kind::larger, a.v, b.v); }
    friend Pack smaller(Pack a, Pack b) { return Symbol::of(Kind::smaller, a.v, b.v); }
    friend Pack reciprocal(Pack a) { return Symbol::of(Kind::reciprocal, a.v); }
    friend Pack inverse_sqrt(Pack a) { return Symbol::of(Kind::inverse_sqrt, a.v); }
};

/// Candidates are loaded with load_repeated, the particle itself with load_spread.
template <>
inline Pack<Symbol> load_repeated<Pack<Symbol>, 1>(const Symbol*) {
    return Symbol::loaded(Symbol::Kind::varying);
}
template <>
inline Pack<Symbol> load_spread<Pack<Symbol>, 1>(const Symbol*) {
    return Symbol::loaded(Symbol::Kind::fixed);
}

/// All columns of real numbers of a view are one and the same: what stands in them does not matter.
template <int Dim>
void point_all_at(const double* column, ParticleView<Dim>& view) {
    const auto point = [column](auto& pointers) {
        using Pointers = std::remove_reference_t<decltype(pointers)>;
        if constexpr (std::is_same_v<Pointers, const double*>)
            pointers = column;
        else if constexpr (!std::is_pointer_v<Pointers>)
            pointers.fill(column);
    };
#define SLUICE_COLUMN(name, ...) point(view.name);
#include "kernels/columns/columns.def"
#undef SLUICE_COLUMN
}

/// Operations per lane that the loop goes over: four particles meet four others, 16 lanes.
template <class Pass>
double operations_per_lane() {
    constexpr int dim = Pass::dim;
    const std::array<double, 4> zeros{};
    ParticleView<dim> particles;
    point_all_at(zeros.data(), particles);
    const ListView::Block block{{0, 1}, {0, 1}};
    const ListView::Part part{{0, 1}, 0};
    const ListedCluster cluster{0, 4, true};
    const ListView::Row row{0, 1, 1};
    const std::uint8_t entry = 0, equal_reach = 1;
    const ListView list{&block, &part, &cluster, &cluster, &row, &entry, &equal_reach, nullptr, nullptr};
    const std::uint64_t before = Ledger::current().operations();
    double sums[4 * Pass::outputs];
    sum_block<Pass, Symbol>(BlockTask<dim>{particles, particles, list, {}}, block, Pass{}, sums);
    return static_cast<double>(Ledger::current().operations() - before) / 16;
}

}  // namespace sluice::counted

/// For the files that compile loops: the count is that of either number type.
#define SLUICE_INSTANTIATE_PASS(Number, ...) SLUICE_COUNT_##Number(__VA_ARGS__)
#define SLUICE_COUNT_double(...) template double operations_per_lane<__VA_ARGS__>();
#define SLUICE_COUNT_float(...)
