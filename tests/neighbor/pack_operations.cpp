// Compiled once per instruction set.
#include "tests/neighbor/pack_operations.hpp"

#include "neighbor/pack.hpp"

namespace sluice::SLUICE_ISA {
namespace {

template <class T>
struct OnRegisters {
    using P = Pack<T>;
    static constexpr int repeated = P::lanes < 4 ? P::lanes : 4;

    static P load(const T* from) {
        P p;
        std::memcpy(&p.v, from, sizeof p.v);
        return p;
    }
    static void store(P p, T* to) { std::memcpy(to, &p.v, sizeof p.v); }

    static void larger_of(const T* a, const T* b, T* out) { store(larger(load(a), load(b)), out); }
    static void smaller_of(const T* a, const T* b, T* out) { store(smaller(load(a), load(b)), out); }
    static void quotient(const T* a, const T* b, T* out) { store(load(a) / load(b), out); }
    static void reciprocal_of(const T* a, T* out) { store(reciprocal(load(a)), out); }
    static void inverse_sqrt_of(const T* a, T* out) { store(inverse_sqrt(load(a)), out); }
    static unsigned mask_of(const T* a, const T* b) { return mask_less(load(a), load(b)); }
    static void repeat(const T* from, T* out) { store(load_repeated<P, repeated>(from), out); }
    static void spread(const T* from, T* out) { store(load_spread<P, repeated>(from), out); }

    static PackOperations<T> all() {
        return {P::lanes,      repeated,        larger_of, smaller_of, quotient,
                reciprocal_of, inverse_sqrt_of, mask_of,   repeat,     spread};
    }
};

}  // namespace

PackOperations<float> operations_on(const float*) { return OnRegisters<float>::all(); }
PackOperations<double> operations_on(const double*) { return OnRegisters<double>::all(); }

}  // namespace sluice::SLUICE_ISA
