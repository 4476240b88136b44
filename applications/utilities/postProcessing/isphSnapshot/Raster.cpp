// SPDX-License-Identifier: GPL-3.0-or-later
#include "Raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isph {

namespace {

constexpr float kEmpty = -std::numeric_limits<float>::infinity();
/// Towards the light: from the upper left, in front of the picture.
const Vec<3> kLight = unit(Vec<3>{{-0.45, 0.65, 0.75}});

}  // namespace

Real brightness(const Vec<3>& normal)
{
    return 0.45 + 0.65 * std::max(dot(normal, kLight), 0.0);
}

Raster::Raster(int width, int height, int samples)
    : width_(width),
      height_(height),
      samples_(samples),
      data_(static_cast<std::size_t>(width) * height * samples * samples, Sample{0, 0, 0, kEmpty})
{
}

void Raster::paint(const Disc& disc)
{
    const Real scale = samples_, radius = std::max(disc.radius * scale, 0.6),
               depth = disc.depth * scale;
    const Real cx = disc.centre[0] * scale - 0.5, cy = disc.centre[1] * scale - 0.5;
    const auto clip = [](Real v, int size) {
        return static_cast<int>(std::clamp(v, 0.0, Real(size)));
    };
    const int columns = width_ * samples_, rows = height_ * samples_;
    const int firstRow = clip(std::ceil(cy - radius), rows),
              endRow = clip(std::floor(cy + radius) + 1, rows);
    const int first = clip(std::ceil(cx - radius), columns),
              end = clip(std::floor(cx + radius) + 1, columns);
    for (int row = firstRow; row < endRow; ++row)
        for (int column = first; column < end; ++column) {
            const Real dx = (column - cx) / radius, dy = (cy - row) / radius;
            const Real rest = 1 - dx * dx - dy * dy;
            if (rest < 0) continue;
            const Real dz = disc.round ? std::sqrt(rest) : 0;
            Sample& sample = data_[static_cast<std::size_t>(row) * columns + column];
            const auto here = static_cast<float>(depth + dz * radius);
            if (here < sample.depth) continue;
            const Real light = disc.round ? brightness({{dx, dy, dz}}) : 1;
            const auto lit = [&](Real c) {
                return static_cast<std::uint8_t>(std::lround(255 * std::min(c * light, 1.0)));
            };
            sample = {lit(disc.colour.red), lit(disc.colour.green), lit(disc.colour.blue), here};
        }
}

std::vector<std::uint32_t> Raster::pixels() const
{
    std::vector<std::uint32_t> out(static_cast<std::size_t>(width_) * height_);
    const int columns = width_ * samples_;
    const int count = samples_ * samples_;
    for (int row = 0; row < height_; ++row)
        for (int column = 0; column < width_; ++column) {
            int sum[4] = {};
            for (int y = 0; y < samples_; ++y)
                for (int x = 0; x < samples_; ++x) {
                    const Sample& s = data_[static_cast<std::size_t>(row * samples_ + y) * columns +
                                            column * samples_ + x];
                    if (s.depth == kEmpty) continue;
                    sum[0] += 255;
                    sum[1] += s.red;
                    sum[2] += s.green;
                    sum[3] += s.blue;
                }
            std::uint32_t pixel = 0;
            for (const int part : sum)
                pixel = pixel << 8 | static_cast<std::uint32_t>((part + count / 2) / count);
            out[static_cast<std::size_t>(row) * width_ + column] = pixel;
        }
    return out;
}

}  // namespace isph
