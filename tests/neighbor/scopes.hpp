// Settings of the whole program that last for a scope.
#pragma once

#include <string>

#include "neighbor/isa.hpp"
#include "neighbor/thread_count.hpp"

namespace sluice {

/// OpenMP's number of threads until the end of the scope.
using ThreadScope = ThreadCount;

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
