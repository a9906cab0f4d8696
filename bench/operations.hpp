// Arithmetic operations of a function of one number, counted as those of passes are (kernels/pairs/operation_count.hpp).
#pragma once

#define SLUICE_ISA counted
#define SLUICE_ISA_counted
#include "kernels/pairs/operation_count.hpp"

namespace sluice::bench {

template <class Function>
double operations_of(const Function& function) {
    using counted::Ledger, counted::Symbol;
    const std::uint64_t before = Ledger::current().operations();
    static_cast<void>(static_cast<double>(function(counted::Pack<Symbol>(Symbol::loaded(Symbol::Kind::varying))).v));
    return static_cast<double>(Ledger::current().operations() - before);
}

}  // namespace sluice::bench
