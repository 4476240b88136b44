// SPDX-License-Identifier: GPL-3.0-or-later
#include "Canvas.hpp"

#include "core/Error.hpp"

#include <cairo.h>

#include <cstring>
#include <numbers>

namespace isph {

namespace {

constexpr Colour kInk{0.13, 0.13, 0.13};

void setColour(cairo_t* to, const Colour& colour)
{
    cairo_set_source_rgb(to, colour.red, colour.green, colour.blue);
}

}  // namespace

struct Canvas::Content {
    Content(int width, int height)
        : surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height)),
          pen(cairo_create(surface))
    {
        if (cairo_status(pen) != CAIRO_STATUS_SUCCESS)
            throw FatalError(std::string("cannot make the picture: ") +
                             cairo_status_to_string(cairo_status(pen)));
    }
    ~Content()
    {
        cairo_destroy(pen);
        cairo_surface_destroy(surface);
    }
    Content(const Content&) = delete;
    Content& operator=(const Content&) = delete;

    cairo_text_extents_t extents(const std::string& words, Real size) const
    {
        cairo_set_font_size(pen, size);
        cairo_text_extents_t found;
        cairo_text_extents(pen, words.c_str(), &found);
        return found;
    }
    /// Half the height of a digit: from a text's middle down to its base line.
    Real drop(Real size) const { return 0.5 * extents("0", size).height; }

    cairo_surface_t* surface;
    cairo_t* pen;
};

Canvas::Canvas(int width, int height) : content_(std::make_unique<Content>(width, height))
{
    cairo_select_font_face(content_->pen, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_line_join(content_->pen, CAIRO_LINE_JOIN_ROUND);
    fill({{0, 0}}, width, height, {1, 1, 1});
}

Canvas::~Canvas() = default;

void Canvas::text(const std::string& words, const Vec<2>& at, Real size, Align align)
{
    const Real width = content_->extents(words, size).x_advance;
    const Real shift = align == Align::left ? 0 : align == Align::centre ? 0.5 * width : width;
    setColour(content_->pen, kInk);
    cairo_move_to(content_->pen, at[0] - shift, at[1] + content_->drop(size));
    cairo_show_text(content_->pen, words.c_str());
}

void Canvas::textUpwards(const std::string& words, const Vec<2>& at, Real size)
{
    cairo_save(content_->pen);
    cairo_translate(content_->pen, at[0], at[1]);
    cairo_rotate(content_->pen, -0.5 * std::numbers::pi);
    text(words, {{0, 0}}, size, Align::centre);
    cairo_restore(content_->pen);
}

Real Canvas::textWidth(const std::string& words, Real size) const
{
    return content_->extents(words, size).x_advance;
}

void Canvas::line(const std::vector<Vec<2>>& points, Real width, const Colour& colour)
{
    setColour(content_->pen, colour);
    cairo_set_line_width(content_->pen, width);
    cairo_new_path(content_->pen);  // without the point where a text ended
    for (const Vec<2>& point : points) cairo_line_to(content_->pen, point[0], point[1]);
    cairo_stroke(content_->pen);
}

void Canvas::circle(const Vec<2>& centre, Real radius, const Colour& inside, const Colour& edge)
{
    cairo_new_path(content_->pen);
    cairo_arc(content_->pen, centre[0], centre[1], radius, 0, 2 * std::numbers::pi);
    setColour(content_->pen, inside);
    cairo_fill_preserve(content_->pen);
    setColour(content_->pen, edge);
    cairo_set_line_width(content_->pen, 0.35 * radius);
    cairo_stroke(content_->pen);
}

void Canvas::fill(const Vec<2>& corner, Real width, Real height, const Colour& colour)
{
    setColour(content_->pen, colour);
    cairo_rectangle(content_->pen, corner[0], corner[1], width, height);
    cairo_fill(content_->pen);
}

void Canvas::clip(const Vec<2>& corner, Real width, Real height)
{
    cairo_reset_clip(content_->pen);
    cairo_rectangle(content_->pen, corner[0], corner[1], width, height);
    cairo_clip(content_->pen);
}

void Canvas::unclip()
{
    cairo_reset_clip(content_->pen);
}

void Canvas::image(const Raster& raster, const Vec<2>& corner)
{
    const std::vector<std::uint32_t> pixels = raster.pixels();
    cairo_surface_t* image =
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, raster.width(), raster.height());
    cairo_surface_flush(image);
    unsigned char* rows = cairo_image_surface_get_data(image);
    const int stride = cairo_image_surface_get_stride(image);
    const std::size_t width = static_cast<std::size_t>(raster.width());
    for (int row = 0; row < raster.height(); ++row)
        std::memcpy(rows + static_cast<std::ptrdiff_t>(row) * stride,
                    &pixels[static_cast<std::size_t>(row) * width], width * sizeof(std::uint32_t));
    cairo_surface_mark_dirty(image);
    cairo_set_source_surface(content_->pen, image, corner[0], corner[1]);
    cairo_paint(content_->pen);
    cairo_surface_destroy(image);
}

void Canvas::writePng(const std::filesystem::path& file) const
{
    const cairo_status_t status = cairo_surface_write_to_png(content_->surface, file.c_str());
    if (status != CAIRO_STATUS_SUCCESS)
        throw FatalIOError(
            std::string("cannot write the picture: ") + cairo_status_to_string(status),
            file.string(), 0);
}

}  // namespace isph
