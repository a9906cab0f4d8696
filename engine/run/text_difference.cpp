#include "engine/run/text_difference.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sluice {
namespace {

using Lines = std::vector<std::string_view>;

Lines lines_of(std::string_view text) {
    Lines lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

/// Above this many pairs of lines all of them count as changed: a scene with long tables of numbers. Their table would
/// take more than 40 MB.
constexpr std::size_t most_pairs = 10'000'000;

/// Length of the longest common subsequence of the lines from i and from j on, for all i and j.
class CommonLines {
  public:
    CommonLines(const Lines& a, const Lines& b) : columns_(b.size() + 1), length_((a.size() + 1) * columns_) {
        for (std::size_t i = a.size(); i-- > 0;)
            for (std::size_t j = b.size(); j-- > 0;)
                at(i, j) = a[i] == b[j] ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
    }
    std::uint32_t& at(std::size_t i, std::size_t j) { return length_[i * columns_ + j]; }

  private:
    std::size_t columns_;
    std::vector<std::uint32_t> length_;
};

/// Takes the lines that both start with, or end with, off both.
void strip_common(Lines& a, Lines& b) {
    const auto [start_a, start_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    a.erase(a.begin(), start_a);
    b.erase(b.begin(), start_b);
    while (!a.empty() && !b.empty() && a.back() == b.back()) {
        a.pop_back();
        b.pop_back();
    }
}

}  // namespace

std::string text_difference(std::string_view before, std::string_view after) {
    Lines a = lines_of(before), b = lines_of(after);
    strip_common(a, b);
    std::string text;
    const auto tell = [&text](const char* sign, std::string_view line) { text.append(sign).append(line) += '\n'; };
    if (a.size() * b.size() > most_pairs) {
        for (const std::string_view line : a) tell("- ", line);
        for (const std::string_view line : b) tell("+ ", line);
        return text;
    }
    CommonLines common(a, b);
    std::size_t i = 0, j = 0;
    while (i < a.size() || j < b.size()) {
        if (i < a.size() && j < b.size() && a[i] == b[j])
            ++i, ++j;
        else if (j == b.size() || (i < a.size() && common.at(i + 1, j) >= common.at(i, j + 1)))
            tell("- ", a[i++]);
        else
            tell("+ ", b[j++]);
    }
    return text;
}

}  // namespace sluice
