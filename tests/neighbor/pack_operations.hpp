// What registers compute, as plain functions that a test can call: one set per instruction set and number type.
#pragma once

namespace sluice {

/// Each function works on one register; arrays hold `lanes` numbers.
template <class T>
struct PackOperations {
    int lanes;
    int repeated;  ///< numbers that load_repeated and load_spread read, lanes / repeated times or on that many lanes
    void (*larger)(const T* a, const T* b, T* out);
    void (*smaller)(const T* a, const T* b, T* out);
    void (*quotient)(const T* a, const T* b, T* out);
    void (*reciprocal)(const T* a, T* out);
    void (*inverse_sqrt)(const T* a, T* out);
    unsigned (*mask_less)(const T* a, const T* b);
    void (*load_repeated)(const T* from, T* out);
    void (*load_spread)(const T* from, T* out);
};

#define SLUICE_DECLARE_OPERATIONS(level)                 \
    namespace level {                                    \
    PackOperations<float> operations_on(const float*);   \
    PackOperations<double> operations_on(const double*); \
    }
SLUICE_DECLARE_OPERATIONS(baseline)
SLUICE_DECLARE_OPERATIONS(avx2)
SLUICE_DECLARE_OPERATIONS(avx512)
#undef SLUICE_DECLARE_OPERATIONS

}  // namespace sluice
