// See share.hpp.
#include "sweep/share.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>

namespace pelage::sweep {

namespace {

// What ranks say to each other. To the dealer: "next"; "row TILE,...", a row of the table; as the last of all "leave",
// with the reason behind a blank where something went wrong, or "interrupted". To a player: a tile's number, or "end".
constexpr const char *next_word = "next", *end_word = "end", *interrupted_word = "interrupted";
const std::string row_word = "row ", leave_word = "leave";

std::string told(const std::exception_ptr& reason) {
    try {
        std::rethrow_exception(reason);
    } catch (const std::exception& error) {
        return error.what();
    }
}

}  // namespace

Dealer::Dealer(Table& table, std::size_t tiles, std::function<bool(std::size_t)> there,
               std::function<void(std::size_t)> changed)
    : table_(table), tiles_(tiles), there_(std::move(there)), changed_(std::move(changed)) {}

std::optional<std::size_t> Dealer::next() {
    const std::lock_guard lock(guard_);
    while (!ended_ && next_ < tiles_) {
        const std::size_t tile = next_++;
        if (!there_(tile)) return tile;
    }
    return std::nullopt;
}

void Dealer::finished(std::size_t tile, const std::string& row) {
    const std::lock_guard lock(guard_);
    ++run_;
    table_.add(tile, row);
    changed_(run_);
}

void Dealer::end(std::exception_ptr reason) {
    const std::lock_guard lock(guard_);
    ended_ = true;
    if (!failure_) failure_ = std::move(reason);
}

void Dealer::answer(cluster::Ranks& ranks, const cluster::Message& message, int& left) {
    const std::string& text = message.text;
    if (text == next_word) {
        const std::optional<std::size_t> tile = next();
        ranks.send(message.from, tile ? std::to_string(*tile) : end_word);
    } else if (text.starts_with(row_word)) {
        const std::string row = text.substr(row_word.size());
        finished(std::strtoull(row.c_str(), nullptr, 10), row);
    } else {
        ++left;
        if (text == interrupted_word) end(nullptr);
        if (text.size() > leave_word.size() && text.starts_with(leave_word))
            end(std::make_exception_ptr(Error(text.substr(leave_word.size() + 1))));
    }
}

void Dealer::serve(cluster::Ranks& ranks) {
    for (int left = 0; left < ranks.count() - 1;) {
        const std::optional<cluster::Message> message = ranks.receive();
        if (!message) continue;
        try {
            answer(ranks, *message, left);
        } catch (...) {  // the table cannot be written: the others are still to be sent home
            end(std::current_exception());
        }
    }
}

std::optional<std::size_t> Player::next() {
    const std::lock_guard lock(guard_);
    if (ended_) return std::nullopt;
    ranks_.send(0, next_word);
    std::optional<cluster::Message> answer;
    while (!answer) answer = ranks_.receive();
    if (answer->text != end_word) return std::strtoull(answer->text.c_str(), nullptr, 10);
    ended_ = true;
    return std::nullopt;
}

void Player::finished(std::size_t, const std::string& row) {
    const std::lock_guard lock(guard_);
    ranks_.send(0, row_word + row);
}

void Player::end(std::exception_ptr reason) {
    const std::lock_guard lock(guard_);
    ended_ = true;
    if (!reason) interrupted_ = true;
    if (reason && reason_.empty()) reason_ = told(reason);
}

void Player::leave() {
    const std::lock_guard lock(guard_);
    ranks_.send(0, !reason_.empty() ? leave_word + " " + reason_ : interrupted_ ? interrupted_word : leave_word);
}

}  // namespace pelage::sweep
