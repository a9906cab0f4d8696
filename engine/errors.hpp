// What can go wrong after a scene has been accepted. (What is wrong with a scene itself is a SceneError.)
#pragma once

#include <stdexcept>

namespace sluice {

/// The computed state has become meaningless: not finite, or beyond what the method can represent.
class NumericalError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A result could not be written. The text names the path and what the system answered.
class OutputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A checkpoint is missing, damaged, or of another scene. The text names file and reason.
class CheckpointError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The folder of a run, or a file in it, cannot be read back. The text names path and reason.
class RunReadError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace sluice
