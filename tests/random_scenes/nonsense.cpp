#include "tests/random_scenes/nonsense.hpp"

#include <algorithm>

namespace random_scenes {
namespace {

const std::vector<std::string> values{"1e308",
                                      "-1e308",
                                      "nan",
                                      "inf",
                                      "-inf",
                                      "-0.0",
                                      "0",
                                      "1e-308",
                                      "5e-324",
                                      "-1",
                                      "1e9",
                                      "1e-9",
                                      "1e17",
                                      "3",
                                      "1e20",
                                      "0.000001",
                                      "\"1/x\"",
                                      "\"t/0\"",
                                      "\"\"",
                                      "[]",
                                      "{}",
                                      "true",
                                      "9223372036854775807",
                                      "-9223372036854775808",
                                      "9223372036854775808",
                                      "\"\\u0000\"",
                                      "1979-05-27"};

/// Begin and length of a number that stands as a value.
struct Piece {
    std::size_t begin, length;
};

std::vector<Piece> numbers_in(const std::string& text) {
    const std::string digits = "0123456789.+-e";
    std::vector<Piece> numbers;
    for (std::size_t at = 0; at < text.size();) {
        const bool starts = at > 0 && std::string(" [=,").find(text[at - 1]) != std::string::npos &&
                            std::string("0123456789-").find(text[at]) != std::string::npos;
        if (!starts) {
            ++at;
            continue;
        }
        const std::size_t end = std::min(text.find_first_not_of(digits, at), text.size());
        numbers.push_back({at, end - at});
        at = end;
    }
    return numbers;
}

std::vector<Piece> lines_in(const std::string& text) {
    std::vector<Piece> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
        lines.push_back({at, end - at});
        at = end;
    }
    return lines;
}

std::string with_accident(std::string text, Random& random) {
    const std::vector<Piece> numbers = numbers_in(text), lines = lines_in(text);
    if (numbers.empty() || lines.empty()) return text;
    const Piece line = random.one_of(lines), number = random.one_of(numbers);
    const std::string copy = text.substr(line.begin, line.length);
    switch (random.below(12)) {
        case 0:
            return text.erase(line.begin, line.length);
        case 1:
            return text.insert(line.begin, copy);
        case 2:
            text.erase(line.begin, line.length);
            return text.insert(random.one_of(lines_in(text)).begin, copy);
        case 3: {
            const std::size_t at = random.below(text.size());
            return text.insert(at, 1, static_cast<char>(random.below(256)));
        }
        default:
            return text.replace(number.begin, number.length, random.one_of(values));
    }
}

}  // namespace

std::string spoilt(std::string text, Random& random) {
    const std::size_t accidents = 1 + random.below(3);
    for (std::size_t k = 0; k < accidents; ++k) text = with_accident(text, random);
    return text;
}

}  // namespace random_scenes
