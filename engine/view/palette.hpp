// The colours of pictures; as the page's.
#pragma once

#include <array>
#include <cstdint>

namespace sluice {

enum class Theme { light, dark };

struct Palette {
    std::uint32_t page, ink, muted, line;
    std::array<std::uint32_t, 3> plain;  ///< of media without a field
};

constexpr Palette palette_of(Theme theme) {
    switch (theme) {
        case Theme::light:
            return {0xffffff, 0x1b1f24, 0x65707c, 0xdde2e7, {0x458cc7, 0xd18042, 0x98a1ab}};
        case Theme::dark:
            return {0x131619, 0xe5e8eb, 0x97a1ac, 0x2e343b, {0x458cc7, 0xd18042, 0x707a85}};
    }
    return {};
}

}  // namespace sluice
