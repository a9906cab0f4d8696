// Checked access to one value of the scene file; every complaint names file, line, key, what was found and expected.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/scene.hpp"

namespace sluice {

/// Which numbers a key accepts, and how to say so.
struct NumberRule {
    std::string_view text;
    bool (*holds)(double);
};
inline constexpr NumberRule any_number{"a number", [](double) { return true; }};
inline constexpr NumberRule positive{"a number > 0", [](double v) { return v > 0; }};
inline constexpr NumberRule not_negative{"a number >= 0", [](double v) { return v >= 0; }};

struct IntegerRange {
    int min = 0;
    int max = 0;
};

/// A value that may be absent; asking an absent one for its content is the error "found nothing".
class TomlValue {
  public:
    /// `misspelt`: a key of the same table that looks like a slip of this absent one; may be empty.
    TomlValue(const toml::node* node, std::string path, Scene& scene, std::string misspelt = {});

    explicit operator bool() const { return node_ != nullptr; }
    const std::string& path() const { return path_; }
    Scene& scene() const { return *scene_; }
    const toml::node* node() const { return node_; }

    double number(const NumberRule& rule = any_number) const;
    int integer(IntegerRange range) const;
    std::string text() const;
    /// Index of the option that the text equals.
    std::size_t choice(const std::vector<std::string>& options) const;
    /// As many numbers as the scene has dimensions.
    Point point() const;
    /// The values of an array.
    std::vector<TomlValue> items(std::string_view expected) const;

    /// What stands in the file, for messages.
    std::string found() const;
    /// "found …, expected …"
    [[noreturn]] void reject(std::string_view expected) const;
    [[noreturn]] void fail(const std::string& message) const;

  private:
    const toml::node* node_;
    std::string path_;
    Scene* scene_;
    std::string misspelt_;
};

/// Line of a value in the file; 0 if the command line put it there.
int line_of(const toml::node& node);

}  // namespace sluice
