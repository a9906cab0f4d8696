#include "engine/view/particle_raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sluice {
namespace {

/// Samples along each side of a pixel, for smooth edges.
constexpr int fine = 2;

std::uint32_t lit(std::uint32_t color, float part) {
    std::uint32_t made = 0;
    for (const unsigned shift : {16U, 8U, 0U}) {
        const float channel = part * static_cast<float>(color >> shift & 0xFFU);
        made |= static_cast<std::uint32_t>(std::min(channel, 255.0F)) << shift;
    }
    return made;
}

/// Of a ball, at (x, y) of its unit disc: mostly diffuse light, so that colours keep what they say. As the page's.
float brightness(float x, float y) {
    const float z = std::sqrt(std::max(0.0F, 1 - x * x - y * y));
    return 0.62F + 0.42F * std::max(0.0F, -0.36F * x - 0.55F * y + 0.75F * z);
}

}  // namespace

ParticleRaster::ParticleRaster(int width, int height)
    : width_(width),
      height_(height),
      color_(static_cast<std::size_t>(width) * height * fine * fine),
      near_(color_.size(), -std::numeric_limits<float>::infinity()) {}

void ParticleRaster::draw(std::span<const Sprite> sprites, Shading shading) {
    for (const Sprite& sprite : sprites) draw_one(sprite, shading);
}

void ParticleRaster::draw_one(const Sprite& sprite, Shading shading) {
    const float cx = fine * sprite.x, cy = fine * sprite.y;
    const float radius = std::max(fine * sprite.radius, 0.7F);  // a sample is never missed
    const auto end = [](float to, int size) { return std::clamp(static_cast<int>(std::ceil(to)), 0, fine * size); };
    const int left = end(cx - radius - 1, width_), right = end(cx + radius, width_);
    const int top = end(cy - radius - 1, height_), bottom = end(cy + radius, height_);
    for (int j = top; j < bottom; ++j)
        for (int i = left; i < right; ++i) {
            const float x = (static_cast<float>(i) + 0.5F - cx) / radius,
                        y = (static_cast<float>(j) + 0.5F - cy) / radius;
            if (x * x + y * y > 1) continue;
            const auto at = static_cast<std::size_t>(j) * fine * width_ + i;
            if (sprite.near < near_[at]) continue;
            near_[at] = sprite.near;
            color_[at] = 0xFF000000U | (shading == Shading::ball ? lit(sprite.color, brightness(x, y)) : sprite.color);
        }
}

void ParticleRaster::blend_into(unsigned char* argb, int stride) const {
    constexpr unsigned samples = fine * fine;
    for (int j = 0; j < height_; ++j)
        for (int i = 0; i < width_; ++i) {
            unsigned sum[3] = {0, 0, 0}, covered = 0;
            for (int s = 0; s < fine * fine; ++s) {
                const std::uint32_t c =
                    color_[static_cast<std::size_t>(j * fine + s / fine) * fine * width_ + i * fine + s % fine];
                if (c == 0) continue;
                ++covered;
                for (unsigned k = 0; k < 3; ++k) sum[k] += c >> (8 * k) & 0xFFU;
            }
            unsigned char* pixel = argb + static_cast<std::size_t>(j) * stride + 4 * i;  // blue, green, red, alpha
            for (unsigned k = 0; k < 3; ++k)
                pixel[k] = static_cast<unsigned char>((sum[k] + (samples - covered) * pixel[k]) / samples);
        }
}

}  // namespace sluice
