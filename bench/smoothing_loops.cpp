// The loops that evaluate smoothing functions, compiled once per instruction set.
#include "bench/smoothing_loops.hpp"

#include "bench/smoothing_functions.hpp"
#include "neighbor/pack.hpp"

namespace sluice::SLUICE_ISA {
namespace {

template <class Number, class Evaluate>
void evaluate_all(const void* q, void* values, Evaluate evaluate) {
    using Real = Pack<Number>;
    const Number* from = static_cast<const Number*>(q);
    Number* to = static_cast<Number*>(values);
    for (std::size_t n = 0; n < bench::smoothing_arguments; n += Real::lanes) {
        const Real value = evaluate(load_repeated<Real, Real::lanes>(from + n));
        std::memcpy(to + n, &value.v, sizeof value.v);
    }
}

template <class Function, class Number>
void shapes(const void* q, void* values) {
    evaluate_all<Number>(
        q, values, [](auto x) __attribute__((always_inline)) { return Function::shape(x); });
}

template <class Function, class Number>
void slopes(const void* q, void* values) {
    evaluate_all<Number>(
        q, values, [](auto x) __attribute__((always_inline)) { return Function::reduced_slope(x); });
}

#define SLUICE_ROWS(name, ...)                                                 \
    {name, "shape", Precision::mixed, shapes<__VA_ARGS__, float>},             \
        {name, "shape", Precision::full, shapes<__VA_ARGS__, double>},         \
        {name, "reduced_slope", Precision::mixed, slopes<__VA_ARGS__, float>}, \
        {name, "reduced_slope", Precision::full, slopes<__VA_ARGS__, double>},
constexpr bench::SmoothingLoop loops[] = {SLUICE_SMOOTHING_FUNCTIONS(SLUICE_ROWS)};
#undef SLUICE_ROWS

}  // namespace

bench::SmoothingLoops smoothing_loops() { return {loops, loops + sizeof loops / sizeof *loops}; }

}  // namespace sluice::SLUICE_ISA
