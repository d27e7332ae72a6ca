// See device.hpp.
#include "opencl/aggregate/device.hpp"

#include "core/inverse_root.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/device/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace pelage {

namespace {

constexpr std::size_t block = 256;  // places, as in the kernels

struct DeviceParticle {  // struct pelage_particle of kernels/aggregate/terms.cl
    cl_float eta, pull, x, y;
    cl_ulong draw;
    cl_float size;
    cl_float unused;
};

struct DeviceFront {  // struct pelage_front of kernels/aggregate/step.cl
    cl_int places = 0, left = 0, charges = 0;
    cl_uint last = no_site;
    cl_int added = 0;
    cl_float last_size = 1.0f;
    cl_long lowest = 0, highest = 0;
    cl_int place[most_new_candidates]{};
    cl_uint site[most_new_candidates]{};
};

std::string source() {
    return Source()
        .file("common/prelude.cl")
        .file("aggregate/terms.cl")
        .file("aggregate/group.cl")
        .file("aggregate/step.cl")
        .file("aggregate/device.cl")
        .str();
}

std::string options(std::size_t items, bool sized) {
    return fmt::format("-DPELAGE_ITEMS={} -DPELAGE_SIZES={}", items, sized ? 1 : 0);
}

// Where a device ends loops silently each group has few places.
std::size_t groups_of(const Session& session) {
    if (session.info().software_rasteriser()) return 64;
    const std::size_t units = std::max<std::size_t>(1, session.info().compute_units);
    return session.options().units == 0 ? units : std::min(units, session.options().units);
}

// With no more places than these, one group is done sooner than several that must be launched for each part of a step.
std::size_t places_of_one_group(const Session& session) {
    if (session.options().path == Path::step) return 0;
    if (session.options().path != Path::automatic) return std::numeric_limits<std::size_t>::max();
    if (session.info().software_rasteriser()) return DeviceInfo::rasteriser_turns / 16;
    return session.info().processor() ? 40'000 : 8'000;
}

}  // namespace

DeviceAggregate::DeviceAggregate(std::shared_ptr<const Session> session, bool sized)
    : session_(std::move(session)),
      sized_(sized),
      items_(growing_items(*session_, block)),
      groups_(groups_of(*session_)),
      places_of_one_group_(places_of_one_group(*session_)) {
    while (!build()) items_ /= 2;
    front_ = session_->buffer(sizeof(DeviceFront), "front of an aggregate");
    particles_ = session_->buffer(most_particles_at_once * sizeof(DeviceParticle), "particles");
    chosen_ = session_->buffer(most_particles_at_once * sizeof(cl_uint), "chosen sites");
    ranges_ = session_->buffer(groups_ * 2 * sizeof(cl_long), "ranges of potentials");
    parts_ = session_->buffer(groups_ * most_new_candidates * sizeof(cl_long), "parts of sums");
}

// False where a group of so many work-items is too large for one of the kernels, whose sums are cut for it.
bool DeviceAggregate::build() {
    const cl::Program program = session_->build(source(), options(items_, sized_));
    gather_ = cl::Kernel(program, "pelage_aggregate_gather");
    weigh_ = cl::Kernel(program, "pelage_aggregate_weigh");
    choose_ = cl::Kernel(program, "pelage_aggregate_choose");
    together_ = cl::Kernel(program, "pelage_aggregate_together");
    add_up_ = cl::Kernel(program, "pelage_aggregate_add_up");
    return groups_fit(*session_, std::array{gather_, weigh_, choose_, together_, add_up_}, items_);
}

// Room for what one batch may add.
void DeviceAggregate::reserve(const Front& front) {
    const std::size_t places = front.places().size() + most_new_candidates * most_particles_at_once;
    if (places > place_room_) {
        place_room_ = (places + places / 2 + block) / block * block;
        enlarge(*session_, places_, place_room_ * sizeof(cl_uint), "candidates");
        enlarge(*session_, sums_, place_room_ * sizeof(cl_long), "sums of candidates");
        enlarge(*session_, blocks_, place_room_ / block * sizeof(cl_ulong), "sums of weights");
        enlarge(*session_, left_, place_room_ * sizeof(cl_int), "places left");
    }
    const std::size_t charges = front.charges().size() + most_particles_at_once;
    if (charges > charge_room_) {
        charge_room_ = charges + charges / 2;
        enlarge(*session_, charges_, charge_room_ * sizeof(cl_uint), "charges");
        enlarge(*session_, sizes_, (sized_ ? charge_room_ : 1) * sizeof(cl_float), "sizes of charges");
    }
}

void DeviceAggregate::write_front(const Front& front) {
    DeviceFront state;
    state.places = static_cast<cl_int>(front.places().size());
    state.left = static_cast<cl_int>(front.left().size());
    state.charges = static_cast<cl_int>(front.charges().size());
    fill(*session_, front_, &state, sizeof state);
}

void DeviceAggregate::bind(const Front& front) {
    Arguments(*session_, gather_).add(places_, sums_, charges_, sizes_, front_, particles_, 0, ranges_, parts_);
    Arguments(*session_, weigh_).add(places_, sums_, front_, particles_, 0, ranges_, parts_, blocks_);
    Arguments(*session_, choose_)
        .add(places_, sums_, charges_, sizes_, front_, particles_, 0, blocks_, left_, sites_, chosen_, front.columns(),
             front.rows());
    Arguments(*session_, together_)
        .add(places_, sums_, charges_, sizes_, front_, particles_, 0, ranges_, parts_, blocks_, left_, sites_, chosen_,
             front.columns(), front.rows());
}

void DeviceAggregate::upload(const Front& front, const std::vector<std::int64_t>& sums) {
    reserve(front);
    const auto pack = [&](const std::vector<std::uint32_t>& sites) {
        std::vector<cl_uint> made(sites.size());
        std::ranges::transform(sites, made.begin(),
                               [&](std::uint32_t site) { return packed_site(site, front.columns()); });
        return made;
    };
    const std::vector<cl_uint> places = pack(front.places()), charges = pack(front.charges());
    fill(*session_, places_, places.data(), places.size() * sizeof(cl_uint));
    fill(*session_, charges_, charges.data(), charges.size() * sizeof(cl_uint));
    if (sized_) fill(*session_, sizes_, front.sizes().data(), charges.size() * sizeof(cl_float));
    fill(*session_, left_, front.left().data(), front.left().size() * sizeof(cl_uint));
    const std::size_t bytes = front.sites().size() * sizeof(cl_int);
    sites_ = session_->buffer(bytes, "sites of an aggregate");
    fill(*session_, sites_, front.sites().data(), bytes);
    if (!sums.empty()) return fill(*session_, sums_, sums.data(), sums.size() * sizeof(cl_long));
    const std::size_t most = places_added_up_at_once(charges.size());
    for (std::size_t first = 0; first < places.size(); first += most) {
        const std::size_t count = std::min(most, places.size() - first);
        Arguments(*session_, add_up_).add(places_, sums_, charges_, sizes_, first, count, charges.size());
        session_->launch(add_up_, cl::NDRange(groups_ * items_), cl::NDRange(items_));
    }
}

// Where a device ends loops silently a launch has fewer of them, each over all charges and once more over the items;
// what such a device counts as a turn is more than that, by less than 16 times (`aggregates/many`).
std::size_t DeviceAggregate::places_added_up_at_once(std::size_t charges) const {
    if (!session_->info().software_rasteriser()) return std::numeric_limits<std::size_t>::max();
    return groups_ * std::max<std::size_t>(1, DeviceInfo::rasteriser_turns / 16 / (charges / items_ + items_ + 1));
}

void DeviceAggregate::launch_step(std::size_t step, bool choose) {
    gather_.setArg(6, static_cast<cl_int>(step));
    weigh_.setArg(4, static_cast<cl_int>(step));
    choose_.setArg(6, static_cast<cl_int>(step));
    session_->launch(gather_, cl::NDRange(groups_ * items_), cl::NDRange(items_));
    session_->launch(weigh_, cl::NDRange(groups_ * items_), cl::NDRange(items_));
    if (choose) session_->launch(choose_, cl::NDRange(items_), cl::NDRange(items_));
}

// Where a device ends loops silently a launch has few turns. A particle's are some eight over the candidates and two
// over the charges for each new candidate.
std::size_t DeviceAggregate::particles_at_once(const Front& front) const {
    if (!session_->info().software_rasteriser()) return most_particles_at_once;
    const std::size_t places = front.places().size() / items_ + 1, charges = front.charges().size() / items_ + 1;
    const std::size_t turns = 8 * (places + block) + 2 * most_new_candidates * charges;
    return std::clamp<std::size_t>(DeviceInfo::rasteriser_turns / turns, 1, most_particles_at_once);
}

std::vector<std::uint32_t> DeviceAggregate::grow(const Front& front, std::span<const Particle> particles) {
    reserve(front);
    write_front(front);
    std::vector<DeviceParticle> asked;
    for (const Particle& one : particles) asked.push_back({one.eta, one.pull, one.x, one.y, one.draw, one.size, 0.0f});
    fill(*session_, particles_, asked.data(), asked.size() * sizeof(DeviceParticle));
    bind(front);
    if (front.places().size() <= places_of_one_group_) {
        together_.setArg(6, static_cast<cl_int>(asked.size()));
        session_->launch(together_, cl::NDRange(items_), cl::NDRange(items_));
    } else {
        for (std::size_t step = 0; step < asked.size(); ++step) launch_step(step, true);
        launch_step(asked.size() - 1, false);  // the sums take in the last charge, and what it made candidates of
    }
    std::vector<cl_uint> chosen(asked.size());
    session_->queue().enqueueReadBuffer(chosen_, CL_TRUE, 0, chosen.size() * sizeof(cl_uint), chosen.data());
    std::vector<std::uint32_t> sites;
    for (const cl_uint site : chosen) {
        if (site != no_site) sites.push_back(unpacked_site(site, front.columns()));
    }
    return sites;
}

std::size_t DeviceAggregate::candidate_bytes() const {
    return place_room_ * (sizeof(cl_uint) + sizeof(cl_long) + sizeof(cl_int)) + place_room_ / block * sizeof(cl_ulong);
}

std::vector<std::int64_t> DeviceAggregate::sums(const Front& front) const {
    const std::size_t places = front.places().size();
    std::vector<std::int64_t> found(places);
    if (places == 0) return found;
    session_->queue().enqueueReadBuffer(sums_, CL_TRUE, 0, places * sizeof(cl_long), found.data());
    return found;
}

}  // namespace pelage
