// Words for the values of an enumeration: one table for each, beside the enumeration (those of scenes: choices.hpp).
// Keys of scenes, readers, and all that is printed take words from there.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace sluice {

template <class Enum>
struct Word {
    Enum value;
    std::string_view word;       ///< as in scenes and files
    std::string_view name = {};  ///< in messages, where that is not the word
};
// Written out for clang 14, which does not deduce the arguments of aggregates.
template <class Enum>
Word(Enum, std::string_view) -> Word<Enum>;
template <class Enum>
Word(Enum, std::string_view, std::string_view) -> Word<Enum>;

/// The table of an enumeration, in the order in which choices are listed.
template <class Enum>
inline constexpr std::array<Word<Enum>, 0> words_of{};

/// The words alone.
template <class Enum>
inline constexpr auto word_list = [] {
    std::array<std::string_view, words_of<Enum>.size()> list{};
    for (std::size_t k = 0; k < list.size(); ++k) {
        list[k] = words_of<Enum>[k].word;
        for (std::size_t earlier = 0; earlier < k; ++earlier)
            if (list[earlier] == list[k] || words_of<Enum>[earlier].value == words_of<Enum>[k].value)
                throw std::logic_error("a word or a value stands twice in its table");
    }
    return list;
}();

/// Throws std::logic_error for a value that has no word.
template <class Enum>
constexpr const Word<Enum>& word_entry(Enum value) {
    for (const Word<Enum>& entry : words_of<Enum>)
        if (entry.value == value) return entry;
    throw std::logic_error("a value without a word");
}

template <class Enum>
constexpr std::string_view word_of(Enum value) {
    return word_entry(value).word;
}

/// The value that has this word; none without one.
template <class Enum>
constexpr std::optional<Enum> value_of_word(std::string_view word) {
    for (const Word<Enum>& entry : words_of<Enum>)
        if (entry.word == word) return entry.value;
    return std::nullopt;
}

/// What messages call it.
template <class Enum>
constexpr std::string_view long_name_of(Enum value) {
    const Word<Enum>& entry = word_entry(value);
    return entry.name.empty() ? entry.word : entry.name;
}

/// The word in quotes, as it stands in a scene.
template <auto value>
inline constexpr auto quoted_letters = [] {
    constexpr std::string_view word = word_of(value);
    std::array<char, word.size() + 2> letters{};
    letters.front() = letters.back() = '"';
    for (std::size_t k = 0; k < word.size(); ++k) letters[k + 1] = word[k];
    return letters;
}();
template <auto value>
inline constexpr std::string_view quoted_word{quoted_letters<value>.data(), quoted_letters<value>.size()};

}  // namespace sluice
