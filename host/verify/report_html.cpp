// See report.hpp: the report as one page that needs no other file.
#include "core/counted.hpp"
#include "io/file_bytes.hpp"
#include "verify/causes.hpp"
#include "verify/report.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>

namespace pelage::verify {

namespace {

constexpr std::string_view style = R"(
body { font: 15px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 64rem; padding: 0 1rem; color: #222; }
table { border-collapse: collapse; margin: 1rem 0; width: 100%; }
th, td { padding: .25rem .6rem; text-align: right; border-bottom: 1px solid #ddd; vertical-align: top; }
th:first-child, td:first-child, td.text { text-align: left; }
.passed { color: #12692a; } .failed { color: #b00020; font-weight: bold; }
.mistrusted, .stopped { color: #a05a00; font-weight: bold; } .skipped { color: #777; }
figure { display: inline-block; margin: .5rem; } figure img { max-width: 18rem; image-rendering: pixelated; }
figcaption { font-size: .85rem; } pre { background: #f5f5f5; padding: .5rem; overflow-x: auto; white-space: pre-wrap; }
@media (prefers-color-scheme: dark) { body { background: #181818; color: #ddd; } pre { background: #262626; }
  th, td { border-color: #444; } .passed { color: #6fcf8b; } .failed { color: #ff7b8a; } .mistrusted, .stopped { color: #f0b060; } }
)";

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string base64(std::string_view bytes) {
    static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            out += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
        }
    }
    return out;
}

std::string badge(const char* verdict) { return fmt::format("<span class=\"{0}\">{0}</span>", verdict); }
std::string badge(Verdict verdict) { return badge(word(verdict)); }

std::string sentence(const Summary& sum) {
    return fmt::format("{} of {} passed, {} failed, {} mistrusted, {} skipped; {} compared, {}.", sum.passed,
                       counted(sum.cases, "case"), sum.failed, sum.mistrusted, sum.skipped,
                       counted(sum.cells_compared, "cell"), counted(sum.cells_differing, "differs", "differ"));
}

std::string cells(std::uint64_t compared, std::uint64_t differing, std::uint64_t ulp, double absolute,
                  double relative) {
    return fmt::format("<td>{}</td><td>{}</td><td>{}</td><td>{:.3g}</td><td>{:.3g}</td>", grouped(compared),
                       grouped(differing), ulp_text(ulp), absolute, relative);
}

constexpr const char* headings =
    "<th>Cells</th><th>Differing</th><th>Max ULP</th><th>Max absolute</th><th>Max relative</th><th>Verdict</th>";

std::string kernels(const DeviceReport& report) {
    std::string text = fmt::format("<table><tr><th>Kernel</th><th>Cases</th>{}</tr>\n", headings);
    for (const Summary& sum : by_kernel(report.results)) {
        text +=
            fmt::format("<tr><td>{}</td><td>{}</td>{}<td>{}</td></tr>\n", escaped(sum.kernel), sum.cases,
                        cells(sum.cells_compared, sum.cells_differing, sum.max_ulp, sum.max_absolute, sum.max_relative),
                        badge(sum.verdict()));
    }
    return text + "</table>\n";
}

std::string failure(const Result& result) {
    std::string text = fmt::format("<h3>{} {}</h3>\n", escaped(result.name), badge(result.verdict));
    if (!result.first.empty()) text += fmt::format("<p>First difference: {}</p>\n", escaped(result.first));
    if (!result.message.empty()) text += fmt::format("<pre>{}</pre>\n", escaped(result.message));
    for (const auto& file : result.files) {
        if (file.extension() != ".png") continue;
        text += fmt::format(
            "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n",
            escaped(file.stem().extension().string().substr(1)), base64(read_file(file)));
    }
    return text;
}

std::string cases(const DeviceReport& report) {
    std::string text =
        fmt::format("<details><summary>All {} cases</summary><table><tr><th>Case</th>{}<th>Note</th></tr>\n",
                    report.results.size(), headings);
    for (const Result& result : report.results) {
        text += fmt::format("<tr><td>{}</td>{}<td>{}</td><td class=\"text\">{}</td></tr>\n", escaped(result.name),
                            cells(result.cells_compared, result.cells_differing, result.max_ulp, result.max_absolute,
                                  result.max_relative),
                            badge(result.verdict), result.verdict == Verdict::failed ? "" : escaped(result.message));
    }
    return text + "</table></details>\n";
}

std::string section(const DeviceReport& report) {
    const DeviceInfo& device = report.device;
    std::string text = fmt::format("<h2>{}</h2>\n<p>{}, {}; driver {}; {}<br>Build options: <code>{}</code></p>\n",
                                   escaped(device.name), escaped(device.platform), escaped(device.platform_version),
                                   escaped(device.driver), escaped(device.version), escaped(report.build_options));
    text += fmt::format("<p>{} {}</p>\n", badge(total(report.results).verdict()), sentence(total(report.results)));
    text += kernels(report);
    const std::string causes = causes_text(report.results);
    if (!causes.empty()) text += fmt::format("<p>Of what failed, {}.</p>\n", escaped(causes));
    for (const Result& result : failures(report.results)) text += failure(result);
    return text + cases(report);
}

}  // namespace

std::string html(const Report& report) {
    std::string text = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width\"><title>pelage verify</title><style>{}</style></head><body>\n"
        "<h1>pelage verify: {}</h1>\n<p>{}, version {}, {} form, seed {}, {:.1f} s. {}</p>\n",
        style, badge(verdict_word(report)), escaped(report.date), escaped(report.version), report.form, report.seed,
        report.seconds, sentence(total(report)));
    for (const std::string& one : conditions(report)) text += fmt::format("<p>{}.</p>\n", escaped(one));
    if (report.devices.size() > 1) {
        const std::vector<std::string> lines = unlike(report);
        text += lines.empty() ? "<p>All devices gave the same bits in every case that they share.</p>\n"
                              : "<p>Cases in which devices differ from each other:</p>\n<ul>\n";
        for (const std::string& line : lines) text += fmt::format("<li>{}</li>\n", escaped(line));
        if (!lines.empty()) text += "</ul>\n";
    }
    for (const DeviceReport& device : report.devices) text += section(device);
    return text + "</body></html>\n";
}

}  // namespace pelage::verify
