// UTF-8, checksums, and work on several threads.
#include "core/error.hpp"
#include "io/parallel.hpp"
#include "io/sha256.hpp"
#include "io/utf8.hpp"
#include "scratch.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <string>

using namespace pelage;

TEST_CASE("text that is UTF-8 stays as it is, other bytes are replaced one by one") {
    const std::string mark = "\xef\xbf\xbd";
    for (const std::string text : {"", "plain", "\xc3\xa4", "\xe2\x82\xac", "\xf0\x9f\x90\x86", "\xef\xbb\xbf//",
                                   "\xed\x9f\xbf", "\xf4\x8f\xbf\xbf"}) {
        CHECK(valid_utf8(text) == text);
    }
    CHECK(valid_utf8("caf\xe9 x") == "caf" + mark + " x");
    CHECK(valid_utf8("\xc3") == mark);
    CHECK(valid_utf8("\xe2\x82x") == mark + mark + "x");
    CHECK(valid_utf8("\xc0\xaf") == mark + mark);             // longer than need be
    CHECK(valid_utf8("\xed\xa0\x80") == mark + mark + mark);  // half of a surrogate pair
    CHECK(valid_utf8("\xf4\x90\x80\x80") == mark + mark + mark + mark);
    CHECK(valid_utf8("\xff\x80") == mark + mark);
}

TEST_CASE("SHA-256 of FIPS 180-4's examples, and around the ends of blocks") {
    CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
          "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    CHECK(sha256(std::string(1000000, 'a')) == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    CHECK(sha256(std::string(55, 'a')) == "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318");
    CHECK(sha256(std::string(56, 'a')) == "b35439a4ac6f0948b6d6f9e3c6af0f5f590ce20f1bde7090ef7970686ec6738a");
    CHECK(sha256(std::string(64, 'a')) == "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb");
}

TEST_CASE("work on several threads is all done, and the first fault is told") {
    std::atomic<int> done{0};
    const auto count = [&] { ++done; };
    for (const std::size_t threads : {0u, 1u, 3u, 100u}) {
        done = 0;
        run_together(std::vector<std::function<void()>>(20, count), threads);
        CHECK(done == 20);
    }
    const auto fault = [](const char* text) { return [text] { throw Error(text); }; };
    CHECK(test::error_of([&] { run_together({count, fault("one"), count}, 1); }) == "one");
    CHECK(test::error_of([&] { run_together({fault("a"), fault("b"), fault("c")}, 3); }).size() == 1);
    run_together({}, 4);
}
