// Settings of the whole program that last for a scope.
#pragma once

#include <omp.h>

#include <string>

#include "neighbor/isa.hpp"

namespace sluice {

/// OpenMP's number of threads until the end of the scope.
class ThreadScope {
  public:
    explicit ThreadScope(int threads) : before_(omp_get_max_threads()) { omp_set_num_threads(threads); }
    ~ThreadScope() { omp_set_num_threads(before_); }
    ThreadScope(const ThreadScope&) = delete;
    ThreadScope& operator=(const ThreadScope&) = delete;

  private:
    int before_;
};

/// The instruction set of all loops until the end of the scope.
class IsaScope {
  public:
    explicit IsaScope(Isa isa) : before_(active_isa()) { use_isa(name_of(isa)); }
    ~IsaScope() { use_isa(name_of(before_)); }
    IsaScope(const IsaScope&) = delete;
    IsaScope& operator=(const IsaScope&) = delete;

  private:
    Isa before_;
};

}  // namespace sluice
