// Checked access to one value of the scene file; every complaint names file, line, key, what was found and expected.
#pragma once

#include <toml++/toml.h>

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/scene.hpp"
#include "engine/scene/table/scene_key.hpp"

namespace sluice {

/// A value that may be absent; asking an absent one for its content is the error "found nothing". What it may be is
/// what the table of keys says of it: asking it for anything else is a mistake of ours, std::logic_error.
class TomlValue {
  public:
    /// `misspelt`: a key of the same table that looks like a slip of this absent one; may be empty.
    TomlValue(const toml::node* node, std::string path, Scene& scene, const SceneKey& key, std::string misspelt = {});

    explicit operator bool() const { return node_ != nullptr; }
    const std::string& path() const { return path_; }
    Scene& scene() const { return *scene_; }
    const toml::node* node() const { return node_; }
    /// Of the array, for one of its values.
    const SceneKey& key() const { return *key_; }

    double number() const;
    int whole() const;
    std::string text() const;
    /// What the word stands for.
    template <class Enum>
    Enum choice() const {
        return words_of<Enum>[index_of_word(word_list<Enum>)].value;
    }
    /// Index of the name that the text equals.
    std::size_t name(const std::vector<std::string>& names) const;
    /// As many numbers as the scene has dimensions.
    Point point() const;
    /// The values of an array; `expected` in place of what the key says.
    std::vector<TomlValue> items(std::string_view expected = {}) const;

    /// What stands in the file, for messages.
    std::string found() const;
    /// What the key says of its values.
    std::string expected() const;
    /// "found …, expected …"
    [[noreturn]] void reject(std::string_view expected) const;
    [[noreturn]] void reject() const { reject(expected()); }
    [[noreturn]] void fail(const std::string& message) const;

  private:
    /// One of an array's values.
    TomlValue(const TomlValue& array, const toml::node& item, std::size_t index);
    /// Throws std::logic_error unless the key has one of these types.
    void must_be(std::initializer_list<KeyType> types) const;
    [[noreturn]] void refuse_type() const;
    /// Throws std::logic_error unless these are the words of the key.
    std::size_t index_of_word(std::span<const std::string_view> words) const;
    std::size_t index_in(const std::vector<std::string>& options) const;

    const toml::node* node_;
    std::string path_;
    Scene* scene_;
    const SceneKey* key_;
    bool is_item_ = false;
    std::string misspelt_;
};

/// Line of a value in the file; 0 if the command line put it there.
int line_of(const toml::node& node);

}  // namespace sluice
