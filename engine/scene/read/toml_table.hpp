// Checked access to one table of the scene file: remembers which keys were asked for, and refuses all others.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/read/toml_value.hpp"

namespace sluice {

/// A table's keys in the order of the file; those added by the command line last.
std::vector<std::string> keys_in_file_order(const toml::table& table);

class TomlTable {
  public:
    /// The file's top level.
    TomlTable(const toml::table& root, Scene& scene);
    /// Fails if the value is no table.
    explicit TomlTable(const TomlValue& value);

    /// The key's value, which may be absent.
    TomlValue get(const std::string& key);
    /// Keys present, in the order of the file; those added by the command line last.
    std::vector<std::string> keys() const;
    /// Fails at the first key that nobody asked for. To be called when everything has been read.
    void finish() const;

    const std::string& path() const { return path_; }
    Scene& scene() const { return *scene_; }
    [[noreturn]] void fail(const std::string& message) const { scene_->fail(path_, message); }

  private:
    std::string path_of(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
    /// Why a key is not expected here: of another kind, of another table, or of none.
    std::string unknown_key(const std::string& key) const;
    bool was_asked(const std::string& key) const;
    /// A key present that nobody has asked for and that looks like a slip of this one; empty if none.
    std::string misspelling_of(const std::string& key) const;

    const toml::table* table_;
    std::string path_;
    std::string_view pattern_;  ///< as in SceneKey::path
    Scene* scene_;
    std::vector<std::string> asked_;
};

}  // namespace sluice
