// Particles as discs or balls in a picture of pixels, without a graphics card.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace sluice {

/// In pixels from the upper left corner; of two in one place the one with the greater `near` is seen.
struct Sprite {
    float x = 0, y = 0, radius = 0, near = 0;
    std::uint32_t color = 0;  ///< 0xRRGGBB
};

/// flat: discs; ball: lit from above the viewer's left shoulder.
enum class Shading { flat, ball };

class ParticleRaster {
  public:
    ParticleRaster(int width, int height);

    void draw(std::span<const Sprite> sprites, Shading shading);
    /// Over what is there. `argb`: as cairo has it, opaque, `stride` bytes a row.
    void blend_into(unsigned char* argb, int stride) const;

  private:
    void draw_one(const Sprite& sprite, Shading shading);

    int width_, height_;                ///< of the picture; the raster is finer
    std::vector<std::uint32_t> color_;  ///< 0xFFRRGGBB, or 0 where nothing is
    std::vector<float> near_;
};

}  // namespace sluice
