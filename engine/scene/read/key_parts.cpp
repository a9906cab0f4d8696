#include "engine/scene/read/key_parts.hpp"

#include <algorithm>
#include <cctype>

namespace sluice {
namespace {

/// Where a string that begins at `at` is over: behind its closing quotes, or at the end of the line or text.
std::size_t end_of_string(std::string_view text, std::size_t at) {
    const char quote = text[at];
    const std::string_view three(quote == '"' ? R"(""")" : "'''");
    const bool many_lines = text.substr(at, 3) == three;
    for (std::size_t k = at + (many_lines ? 3 : 1); k < text.size(); ++k) {
        if (quote == '"' && text[k] == '\\')
            ++k;
        else if (many_lines && text.substr(k, 3) == three)
            return k + 3;
        else if (!many_lines && (text[k] == quote || text[k] == '\n'))
            return k + (text[k] == quote);
    }
    return text.size();
}

bool belongs_to_key(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == ' ' || c == '\t';
}

}  // namespace

int line_of_long_key(std::string_view text) {
    int line = 1, dots = 0;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '"' || c == '\'') {
            const std::size_t end = end_of_string(text, at);
            line += static_cast<int>(std::count(text.begin() + at, text.begin() + end, '\n'));
            at = end;
            continue;
        }
        if (c == '.' && ++dots == most_key_parts) return line;
        if (c != '.' && !belongs_to_key(c)) dots = 0;
        if (c == '\n') ++line;
        at = c == '#' ? std::min(text.find('\n', at), text.size()) : at + 1;
    }
    return 0;
}

}  // namespace sluice
