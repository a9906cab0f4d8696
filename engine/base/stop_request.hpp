// Ctrl-C and `kill` as a wish that the run can grant at the end of a step.
#pragma once

#include <signal.h>

namespace sluice {

/// While it lives, the first SIGINT or SIGTERM is only noted; a second one ends the program as usual.
class StopRequest {
  public:
    StopRequest();
    ~StopRequest();
    StopRequest(const StopRequest&) = delete;
    StopRequest& operator=(const StopRequest&) = delete;

    bool received() const;

  private:
    struct sigaction old_interrupt_ {};
    struct sigaction old_terminate_ {};
};

}  // namespace sluice
