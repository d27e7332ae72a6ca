// See far_device.hpp.
#include "opencl/aggregate/far_device.hpp"

#include "opencl/aggregate/far_layout.hpp"
#include "opencl/aggregate/far_tables.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/device/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace pelage {

namespace {

constexpr std::size_t chunk = 32;  // candidates or charges, as in the kernels
constexpr std::size_t most_looking_groups = 4096;
constexpr std::size_t most_at_once = 64;  // particles of a launch: for each there must be room

std::string far_source() {
    Source source;
    source.file("common/prelude.cl").file("rules/philox.cl").file("aggregate/terms.cl").file("aggregate/group.cl");
    for (const char* part : {"tree", "field", "take", "choose", "draw", "device"})
        source.file(fmt::format("aggregate/far_{}.cl", part));
    return source.str();
}

std::string far_options(std::size_t items, bool sized, std::size_t leaf) {
    return fmt::format("-DPELAGE_ITEMS={} -DPELAGE_SIZES={} -DPELAGE_LEAF={}", items, sized ? 1 : 0, leaf);
}

// A processor takes one item, whose loops its compiler turns into vectors; PoCL, whatever is asked for: it copies what
// comes after a barrier for each way that leads there, and here many do.
std::size_t far_items(const Session& session) {
    constexpr std::size_t most = 256;
    const bool one = session.info().processor() && !session.info().watches_memory();
    return one ? 1 : growing_items(session, most);
}

}  // namespace

DeviceFarAggregate::DeviceFarAggregate(std::shared_ptr<const Session> session, bool sized, FarGrid grid)
    : session_(std::move(session)), sized_(sized), grid_(std::move(grid)), items_(far_items(*session_)) {
    while (!build()) items_ /= 2;
    const std::vector<DeviceLevel> levels = device_levels(grid_);
    levels_ = session_->buffer(levels.size() * sizeof(DeviceLevel), "levels of blocks");
    fill(*session_, levels_, levels.data(), levels.size() * sizeof(DeviceLevel));
    const std::vector<float> tables = far_tables(grid_.levels.front().side);
    tables_ = session_->buffer(tables.size() * sizeof(cl_float), "tables of a far field");
    fill(*session_, tables_, tables.data(), tables.size() * sizeof(cl_float));
    front_ = session_->buffer(sizeof(DeviceFarFront), "front of an aggregate");
    leaves_ = session_->buffer(grid_.leaves() * sizeof(DeviceLeaf), "leaves");
    looked_at_ = session_->buffer(grid_.leaves() * sizeof(cl_int), "leaves looked at");
    coefficients_ = session_->buffer(grid_.blocks() * far_coefficients * sizeof(cl_long), "coefficients of blocks");
    added_ = session_->buffer(grid_.blocks() * sizeof(cl_long), "additions to blocks");
    best_ = session_->buffer(grid_.blocks() * sizeof(cl_long), "bounds of blocks");
    totals_ = session_->buffer(grid_.blocks() * sizeof(cl_ulong), "weights of blocks");
    particles_ = session_->buffer(most_at_once * sizeof(DeviceFarParticle), "particles");
    chosen_ = session_->buffer(most_at_once * sizeof(cl_uint), "chosen sites");
}

bool DeviceFarAggregate::build() {
    const std::size_t leaf = grid_.levels.front().side;
    const cl::Program program = session_->build(far_source(), far_options(items_, sized_, leaf));
    grow_ = cl::Kernel(program, "pelage_far_grow");
    replay_ = cl::Kernel(program, "pelage_far_replay");
    look_ = cl::Kernel(program, "pelage_far_look");
    renew_ = cl::Kernel(program, "pelage_far_renew");
    return groups_fit(*session_, std::array{grow_, replay_, look_, renew_}, items_);
}

// What every kernel begins with; returns the place of the next argument.
cl_uint DeviceFarAggregate::bind(cl::Kernel& kernel) const {
    return Arguments(*session_, kernel)
        .add(levels_, tables_, front_, leaves_, coefficients_, added_, best_, totals_, states_, sites_, near_, known_,
             next_, charges_, sizes_, charge_next_, looked_at_, grid_.levels.size(), columns_, rows_)
        .next();
}

void DeviceFarAggregate::run(const cl::Kernel& kernel, std::size_t groups) const {
    session_->launch(kernel, cl::NDRange(groups * items_), cl::NDRange(items_));
}

// Nothing is there yet but walls.
void DeviceFarAggregate::clear(const Front& front) {
    columns_ = front.columns();
    rows_ = front.rows();
    const DeviceFarFront empty;
    fill(*session_, front_, &empty, sizeof empty);
    const std::vector<DeviceLeaf> leaves(grid_.leaves());
    fill(*session_, leaves_, leaves.data(), leaves.size() * sizeof(DeviceLeaf));
    const std::vector<cl_long> zeros(grid_.blocks() * far_coefficients, 0);
    fill(*session_, coefficients_, zeros.data(), zeros.size() * sizeof(cl_long));
    fill(*session_, added_, zeros.data(), grid_.blocks() * sizeof(cl_long));
    fill(*session_, totals_, zeros.data(), grid_.blocks() * sizeof(cl_ulong));
    const std::vector<cl_long> nothing(grid_.blocks(), -(cl_long{1} << 62));
    fill(*session_, best_, nothing.data(), nothing.size() * sizeof(cl_long));
    clear_states(front);
    candidate_chunks_ = charge_chunks_ = 0;
}

void DeviceFarAggregate::clear_states(const Front& front) {
    constexpr std::size_t in_word = 16;
    std::vector<cl_uint> states((front.sites().size() + in_word - 1) / in_word, 0);
    for (std::size_t site = 0; site < front.sites().size(); ++site) {
        if (front.sites()[site] == Front::closed) states[site / in_word] |= 3u << (site % in_word * 2);
    }
    states_ = session_->buffer(states.size() * sizeof(cl_uint), "states of sites");
    fill(*session_, states_, states.data(), states.size() * sizeof(cl_uint));
}

// Room for what so many more charges may need: the new candidates of one lie in four leaves at most, and begin no more
// than one chunk in each.
void DeviceFarAggregate::reserve(std::size_t more) {
    candidate_chunks_ += 4 * more;
    charge_chunks_ += more;
    if (candidate_chunks_ > candidate_room_) reserve_candidates(candidate_chunks_ + candidate_chunks_ / 8);
    if (charge_chunks_ > charge_room_) reserve_charges(charge_chunks_ + charge_chunks_ / 8);
}

std::size_t DeviceFarAggregate::candidate_bytes() const {
    return candidate_room_ * (chunk * (sizeof(cl_uint) + 2 * sizeof(cl_long)) + sizeof(cl_int));
}

void DeviceFarAggregate::reserve_candidates(std::size_t chunks) {
    candidate_room_ = chunks;
    enlarge(*session_, sites_, chunks * chunk * sizeof(cl_uint), "candidates");
    enlarge(*session_, near_, chunks * chunk * sizeof(cl_long), "sums of near charges");
    enlarge(*session_, known_, chunks * chunk * sizeof(cl_long), "sums of candidates");
    enlarge(*session_, next_, chunks * sizeof(cl_int), "chains of candidates");
}

void DeviceFarAggregate::reserve_charges(std::size_t chunks) {
    charge_room_ = chunks;
    enlarge(*session_, charges_, chunks * chunk * sizeof(cl_uint), "charges");
    enlarge(*session_, sizes_, (sized_ ? chunks * chunk : 1) * sizeof(cl_float), "sizes of charges");
    enlarge(*session_, charge_next_, chunks * sizeof(cl_int), "chains of charges");
}

void DeviceFarAggregate::upload(const Front& front, const std::vector<std::int64_t>&) {
    clear(front);
    const std::size_t count = front.charges().size(), renewed = far_renewal(count);
    for (std::size_t first = 0; first < count;) {
        const std::size_t end = first < renewed ? renewed : count;
        const std::size_t some = std::min(end - first, session_->info().software_rasteriser() ? 1 : most_at_once);
        replay(front, first, some);
        first += some;
        if (first == renewed) renew();
    }
}

void DeviceFarAggregate::replay(const Front& front, std::size_t first, std::size_t count) {
    reserve(count);
    std::vector<cl_uint> sites;
    for (std::size_t i = first; i < first + count; ++i)
        sites.push_back(packed_site(front.charges()[i], front.columns()));
    const cl::Buffer arrived = session_->buffer(count * sizeof(cl_uint), "charges that arrived");
    const cl::Buffer sizes = session_->buffer(count * sizeof(cl_float), "sizes of charges that arrived");
    fill(*session_, arrived, sites.data(), count * sizeof(cl_uint));
    fill(*session_, sizes, front.sizes().data() + first, count * sizeof(cl_float));
    Arguments(*session_, replay_, bind(replay_)).add(arrived, sizes, count);
    run(replay_, 1);
    count_chunks();
}

// Those in use; returns how many charges there are.
std::size_t DeviceFarAggregate::count_chunks() {
    DeviceFarFront state;
    session_->queue().enqueueReadBuffer(front_, CL_TRUE, 0, sizeof state, &state);
    candidate_chunks_ = static_cast<std::size_t>(state.chunks);
    charge_chunks_ = static_cast<std::size_t>(state.charge_chunks);
    return static_cast<std::size_t>(state.charges);
}

std::size_t DeviceFarAggregate::looking_groups() const {
    if (session_->info().software_rasteriser()) return grid_.leaves();
    const std::size_t units = std::max<std::size_t>(1, session_->info().compute_units);
    if (!session_->info().processor()) return std::min(grid_.leaves(), most_looking_groups);
    return session_->options().units == 0 ? units : std::min(units, session_->options().units);
}

void DeviceFarAggregate::renew() {
    Arguments(*session_, look_, bind(look_)).add(0, sites_, known_);
    run(look_, looking_groups());
    bind(renew_);
    run(renew_, 1);
}

// Until the bounds are to be made anew.
std::size_t DeviceFarAggregate::particles_at_once(const Front& front) const {
    if (session_->info().software_rasteriser()) return 1;
    const std::size_t charges = front.charges().size();
    std::size_t count = 1;
    while (count < most_at_once && far_renewal(charges + count) != charges + count) ++count;
    return count;
}

std::vector<std::uint32_t> DeviceFarAggregate::grow(const Front& front, std::span<const Particle> particles) {
    reserve(particles.size());
    std::vector<DeviceFarParticle> asked;
    for (const Particle& one : particles) asked.push_back(device_particle(one));
    fill(*session_, particles_, asked.data(), asked.size() * sizeof(DeviceFarParticle));
    Arguments(*session_, grow_, bind(grow_)).add(particles_, asked.size(), chosen_);
    run(grow_, 1);
    std::vector<cl_uint> chosen(asked.size());
    session_->queue().enqueueReadBuffer(chosen_, CL_TRUE, 0, chosen.size() * sizeof(cl_uint), chosen.data());
    const std::size_t charges = count_chunks();
    if (charges > front.charges().size() && far_renewal(charges) == charges) renew();
    std::vector<std::uint32_t> sites;
    for (const cl_uint site : chosen) {
        if (site != no_site) sites.push_back(unpacked_site(site, front.columns()));
    }
    return sites;
}

std::vector<std::int64_t> DeviceFarAggregate::sums(const Front& front) const {
    std::vector<std::int64_t> found(front.places().size(), 0);
    const std::size_t slots = candidate_chunks_ * chunk;
    if (slots == 0) return found;
    std::vector<cl_uint> sites(slots, no_site);
    const cl::Buffer shown_sites = session_->buffer(slots * sizeof(cl_uint), "sites to show");
    const cl::Buffer shown = session_->buffer(slots * sizeof(cl_long), "sums to show");
    fill(*session_, shown_sites, sites.data(), slots * sizeof(cl_uint));
    Arguments(*session_, look_, bind(look_)).add(1, shown_sites, shown);
    run(look_, looking_groups());
    std::vector<cl_long> sums(slots);
    session_->queue().enqueueReadBuffer(shown_sites, CL_TRUE, 0, slots * sizeof(cl_uint), sites.data());
    session_->queue().enqueueReadBuffer(shown, CL_TRUE, 0, slots * sizeof(cl_long), sums.data());
    for (std::size_t slot = 0; slot < slots; ++slot) {
        if (sites[slot] == no_site) continue;
        const std::uint32_t site = unpacked_site(sites[slot], front.columns());
        found[static_cast<std::size_t>(front.sites()[site])] = sums[slot];
    }
    return found;
}

}  // namespace pelage
