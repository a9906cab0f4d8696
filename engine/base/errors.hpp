// The library's errors are part of what other programs see.
#pragma once

#include "engine/include/sluice/errors.hpp"
