#include "engine/scene/read/syntax_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <vector>

namespace sluice {
namespace {

struct Bracket {
    char kind = '[';
    TextPlace at;
};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// Brackets that are open at a place; those in texts and comments do not count.
class OpenBrackets {
  public:
    OpenBrackets(std::string_view text, TextPlace end) {
        TextPlace at;
        for (const char c : text) {
            if (at.line > end.line || (at.line == end.line && at.column >= end.column)) break;
            take(c, at);
            at = c == '\n' ? TextPlace{at.line + 1, 1} : TextPlace{at.line, at.column + 1};
        }
    }
    std::optional<Bracket> innermost() const {
        return open_.empty() ? std::nullopt : std::optional<Bracket>(open_.back());
    }

  private:
    void take(char c, TextPlace at) {
        if (c == '\n') {
            quote_ = '\0';
            comment_ = false;
        } else if (comment_) {
            return;
        } else if (quote_ != '\0') {
            if (c == quote_) quote_ = '\0';
        } else if (c == '"' || c == '\'') {
            quote_ = c;
        } else if (c == '#') {
            comment_ = true;
        } else if (c == '[' || c == '{') {
            open_.push_back({c, at});
        } else if ((c == ']' || c == '}') && !open_.empty()) {
            open_.pop_back();
        }
    }
    std::vector<Bracket> open_;
    char quote_ = '\0';
    bool comment_ = false;
};

std::string_view line_of_text(std::string_view text, std::size_t number) {
    for (std::size_t line = 1; line < number; ++line) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    return text.substr(0, text.find('\n'));
}

/// Letters that may stand in a number or a bare word, around a column (from 0).
std::string_view token_around(std::string_view line, std::size_t column) {
    const auto belongs = [](char c) {
        return is_digit(c) || is_letter(c) || std::string_view("+-._,/*^").find(c) != std::string_view::npos;
    };
    std::size_t begin = std::min(column, line.size()), end = begin;
    while (begin > 0 && belongs(line[begin - 1])) --begin;
    while (end < line.size() && belongs(line[end])) ++end;
    return line.substr(begin, end - begin);
}

std::string with_point(std::string_view number) {
    std::string mended(number);
    std::replace(mended.begin(), mended.end(), ',', '.');
    return mended;
}

bool is_decimal_comma(std::string_view token) {
    const std::size_t comma = token.find(',');
    return comma != std::string_view::npos && comma > 0 && comma + 1 < token.size() && is_digit(token[comma - 1]) &&
           is_digit(token[comma + 1]);
}

/// A number whose point has a digit on one side only, with the other one added.
std::string completed(std::string_view number) {
    std::string mended;
    for (std::size_t k = 0; k < number.size(); ++k) {
        const bool point = number[k] == '.';
        if (point && (k == 0 || !is_digit(number[k - 1]))) mended += '0';
        mended += number[k];
        if (point && (k + 1 == number.size() || !is_digit(number[k + 1]))) mended += '0';
    }
    return mended;
}

bool looks_like_key(std::string_view rest) {
    std::size_t k = 0;
    while (k < rest.size() && (is_letter(rest[k]) || is_digit(rest[k]) || rest[k] == '_' || rest[k] == '-')) ++k;
    const std::size_t word = k;
    while (k < rest.size() && is_blank(rest[k])) ++k;
    return word > 0 && k < rest.size() && rest[k] == '=';
}

/// Arrays may go on over lines, so that a missing bracket is noticed at the next key or heading only.
std::optional<std::string> unclosed(const Bracket& open, TextPlace at, std::string_view line) {
    const std::string_view rest = line.substr(std::min(at.column - 1, line.size()));
    const bool ends = at.line > open.at.line || rest.empty() || rest == "\r" || rest.starts_with('[');
    if (!ends && !(open.kind == '[' && looks_like_key(rest))) return std::nullopt;
    return fmt::format("{}:{}: found a {} that is not closed, expected a {} {}", open.at.line, open.at.column,
                       open.kind, open.kind == '[' ? ']' : '}',
                       open.kind == '{'         ? "in the same line"
                       : at.line > open.at.line ? "behind its last value"
                                                : "before the next key");
}

/// What stands where the parser gave up, in words; empty if it looks like nothing known.
std::string explain_token(std::string_view line, std::size_t column, std::string_view description) {
    const std::string_view token = token_around(line, column);
    const std::size_t equals = line.find('=');
    const bool in_value = equals != std::string_view::npos && column > equals;
    if (description.find("unescaped control characters") != std::string_view::npos)
        return "found a text without its closing quote, expected it in the same line";
    if (!in_value && column < line.size() && line[column] == ':') return "found a colon, expected key = value";
    if (!in_value || token.empty()) return "";
    if (is_decimal_comma(token)) return fmt::format("found {}, expected a point: {}", token, with_point(token));
    if (is_letter(token[0])) {
        std::string_view before = line.substr(0, static_cast<std::size_t>(token.data() - line.data()));
        while (!before.empty() && is_blank(before.back())) before.remove_suffix(1);
        if (!before.empty() && is_digit(before.back()))
            return fmt::format("found {} behind a number, expected the number alone, in SI units", token);
        return fmt::format("found {} without quotes, expected \"{}\"", token, token);
    }
    if (token.find_first_of("/*^") != std::string_view::npos)
        return fmt::format("found {}, expected a number; only formulas, in quotes, are computed", token);
    if (completed(token) != token)
        return fmt::format("found {}, expected digits on both sides of the point: {}", token, completed(token));
    return "";
}

/// What a line defines: "[bodies.water]", or the key before its "=".
std::string_view defined_in(std::string_view line) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    std::string_view name = line.substr(0, line.starts_with('[') ? line.find(']') + 1 : line.find('='));
    while (!name.empty() && is_blank(name.back())) name.remove_suffix(1);
    return name;
}

/// A table or key that is there twice; empty if the first is not found.
std::string explain_second(std::string_view text, std::size_t number) {
    const std::string_view name = defined_in(line_of_text(text, number));
    for (std::size_t line = number - 1; line > 0; --line)
        if (!name.empty() && defined_in(line_of_text(text, line)) == name)
            return fmt::format("found a second {}, expected one; the first is in line {}", name, line);
    return "";
}

}  // namespace

std::string explain_syntax_error(std::string_view text, TextPlace at, std::string_view description) {
    const std::string_view line = line_of_text(text, at.line);
    if (const auto open = OpenBrackets(text, at).innermost())
        if (const auto told = unclosed(*open, at, line)) return *told;
    const bool second = description.find("cannot redefine") != std::string_view::npos;
    const std::string told = second ? explain_second(text, at.line) : explain_token(line, at.column - 1, description);
    return fmt::format("{}:{}: {}", at.line, at.column, told.empty() ? description : told);
}

}  // namespace sluice
