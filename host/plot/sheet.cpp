// See sheet.hpp.
#include "plot/sheet.hpp"

#include "core/error.hpp"
#include "plot/text.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace pelage::plot {

namespace {

// Pixels on a sheet of up to `usual` of them; on a larger one all grows with it.
struct Measures {
    explicit Measures(double size) : grown(std::max(1.0, size / usual)) {}

    static constexpr double usual = 1500;
    double grown;
    double left = 110 * grown, right = 130 * grown, top = 50 * grown, bottom = 70 * grown, letters = 15 * grown;
};

struct Free {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, Free>;
using Context = std::unique_ptr<cairo_t, Free>;

Surface canvas(const std::filesystem::path& file, double width, double height) {
    if (file.extension() == ".svg") return Surface(cairo_svg_surface_create(file.c_str(), width, height));
    if (file.extension() == ".pdf") return Surface(cairo_pdf_surface_create(file.c_str(), width, height));
    return Surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)));
}

double title_width(const std::string& words, double size) {
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, 1));
    const Context context(cairo_create(surface.get()));
    cairo_select_font_face(context.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    return width_of_text(context.get(), words, size);
}

void check(cairo_status_t status, const std::filesystem::path& file) {
    if (status != CAIRO_STATUS_SUCCESS)
        throw Error(fmt::format("cannot draw '{}': {}", file.string(), cairo_status_to_string(status)));
}

class Sheet {
public:
    Sheet(const nlohmann::json& what, const std::filesystem::path& file)
        : what_(what), mosaic_(cairo_image_surface_create_from_png(what.at("mosaic").get<std::string>().c_str())) {
        check(cairo_surface_status(mosaic_.get()), what.at("mosaic").get<std::string>());
        width_ = cairo_image_surface_get_width(mosaic_.get());
        height_ = cairo_image_surface_get_height(mosaic_.get());
        m_ = Measures(std::max(width_, height_));
        const double title = m_.left + title_width(what.at("title").get<std::string>(), m_.letters * 1.15) + 20;
        surface_ = canvas(file, std::max({m_.left + width_ + m_.right, title, 480.0}),
                          std::max(m_.top + height_ + m_.bottom, 220.0));
        check(cairo_surface_status(surface_.get()), file);
        cairo_.reset(cairo_create(surface_.get()));
    }

    void draw() {
        cairo_t* cairo = cairo_.get();
        cairo_set_source_rgb(cairo, 1, 1, 1);
        cairo_paint(cairo);
        cairo_set_source_surface(cairo, mosaic_.get(), m_.left, m_.top);
        cairo_paint(cairo);
        cairo_set_source_rgb(cairo, 0.13, 0.13, 0.15);
        cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
        text(m_.left, m_.top / 2, what_.at("title").get<std::string>(), m_.letters * 1.15, 0);
        if (what_.contains("x")) axes();
        if (what_.contains("colours")) bar();
    }

    void write(const std::filesystem::path& file) {
        if (file.extension() == ".png") check(cairo_surface_write_to_png(surface_.get(), file.c_str()), file);
        cairo_surface_finish(surface_.get());
        check(cairo_surface_status(surface_.get()), file);
    }

private:
    void axes() {
        const double across = what_.at("tile").at(0), down = what_.at("tile").at(1), gap = what_.at("gap");
        const auto x = what_.at("x").at("values").get<std::vector<std::string>>();
        const auto y = what_.at("y").at("values").get<std::vector<std::string>>();
        double widest = 0;
        for (const std::string& value : x) widest = std::max(widest, width_of_text(cairo_.get(), value, m_.letters));
        const auto every = 1 + static_cast<std::size_t>((widest + 10 * m_.grown) / (across + gap));
        for (std::size_t i = 0; i < x.size(); i += every)
            text(m_.left + static_cast<double>(i) * (across + gap) + across / 2, m_.top + height_ + 16 * m_.grown, x[i],
                 m_.letters, 0.5);
        for (std::size_t i = 0; i < y.size(); ++i)
            text(m_.left - 8 * m_.grown, m_.top + height_ - static_cast<double>(i) * (down + gap) - down / 2, y[i],
                 m_.letters, 1);
        text(m_.left + width_ / 2, m_.top + height_ + 44 * m_.grown, what_.at("x").at("name").get<std::string>(),
             m_.letters * 1.15, 0.5);
        text(24 * m_.grown, m_.top + height_ / 2, what_.at("y").at("name").get<std::string>(), m_.letters * 1.15, 0.5,
             true);
    }

    void bar() {
        cairo_t* cairo = cairo_.get();
        const auto& colours = what_.at("colours");
        const double x = m_.left + width_ + 24 * m_.grown, height = std::min(height_, 400.0 * m_.grown);
        const double step = height / static_cast<double>(colours.size());
        for (std::size_t i = 0; i < colours.size(); ++i) {
            const auto channel = [&](std::size_t c) { return colours.at(i).at(c).get<double>() / 255; };
            cairo_set_source_rgb(cairo, channel(0), channel(1), channel(2));
            cairo_rectangle(cairo, x, m_.top + height - static_cast<double>(i + 1) * step, 16 * m_.grown, step + 0.5);
            cairo_fill(cairo);
        }
        cairo_set_source_rgb(cairo, 0.13, 0.13, 0.15);
        text(x + 22 * m_.grown, m_.top + 6 * m_.grown, fmt::format("{:.4g}", what_.at("range").at(1).get<double>()),
             m_.letters, 0);
        text(x + 22 * m_.grown, m_.top + height - 6 * m_.grown,
             fmt::format("{:.4g}", what_.at("range").at(0).get<double>()), m_.letters, 0);
    }

    void text(double x, double y, const std::string& words, double size, double lean, bool upward = false) {
        draw_text(cairo_.get(), x, y, words, size, lean, upward);
    }

    const nlohmann::json& what_;
    Surface mosaic_, surface_;
    Context cairo_;
    double width_ = 0, height_ = 0;
    Measures m_{0};
};

}  // namespace

void draw_sheet(const nlohmann::json& what, const std::filesystem::path& file) {
    Sheet sheet(what, file);
    sheet.draw();
    sheet.write(file);
}

}  // namespace pelage::plot
