// OpenEXR's streams over memory and over files that appear whole or not at all.
#pragma once

#include "io/atomic_file.hpp"

#include <ImfIO.h>
#include <string_view>

namespace pelage {

class ExrInput : public Imf::IStream {
public:
    ExrInput(std::string_view bytes, const std::string& name) : IStream(name.c_str()), bytes_(bytes) {}
    bool read(char to[], int count) override;
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t position) override { at_ = position; }

private:
    std::string_view bytes_;
    std::uint64_t at_ = 0;
};

class ExrOutput : public Imf::OStream {
public:
    ExrOutput(AtomicFile& file, const std::string& name) : OStream(name.c_str()), file_(file) {}
    void write(const char from[], int count) override { file_.write(from, static_cast<std::size_t>(count)); }
    std::uint64_t tellp() override { return file_.position(); }
    void seekp(std::uint64_t position) override { file_.seek(position); }

private:
    AtomicFile& file_;
};

}  // namespace pelage
