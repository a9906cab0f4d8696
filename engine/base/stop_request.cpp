#include "engine/base/stop_request.hpp"

namespace sluice {
namespace {

volatile sig_atomic_t stop_wanted = 0;

void note(int) { stop_wanted = 1; }

}  // namespace

StopRequest::StopRequest() {
    stop_wanted = 0;
    struct sigaction action {};
    action.sa_handler = note;
    // RESETHAND: a second signal has its usual effect. RESTART: writes in progress are not cut short.
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, &old_interrupt_);
    sigaction(SIGTERM, &action, &old_terminate_);
}

StopRequest::~StopRequest() {
    sigaction(SIGINT, &old_interrupt_, nullptr);
    sigaction(SIGTERM, &old_terminate_, nullptr);
}

bool StopRequest::received() const { return stop_wanted != 0; }

}  // namespace sluice
