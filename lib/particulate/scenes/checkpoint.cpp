#include <particulate/scenes/checkpoint.hpp>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::scenes {

namespace {

static_assert(std::numeric_limits<double>::is_iec559 && sizeof(double) == 8);

constexpr std::string_view kind = "particulate checkpoint, version ";
constexpr std::string_view version = "1";
constexpr std::string_view order = std::endian::native == std::endian::little ? ", little endian" : ", big endian";
constexpr std::string_view more = "more.";

// FNV-1a: every single byte that changes changes it.
std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const char byte : bytes) sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  return sum;
}

std::string last_line(std::string_view bytes) { return fmt::format("checksum {:016x}\n", checksum(bytes)); }

void add(std::string& bytes, std::string_view name, std::string_view text) {
  bytes += fmt::format("{} text {}\n", name, text.size());
  bytes += text;
  bytes += '\n';
}

void add(std::string& bytes, std::string_view name, std::span<const double> numbers) {
  bytes += fmt::format("{} real {}\n", name, numbers.size());
  // Of no numbers there may be no place to read from.
  if (!numbers.empty()) bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
  bytes += '\n';
}

std::span<const double> numbers_of(const Eigen::VectorXd& x) { return {x.data(), static_cast<std::size_t>(x.size())}; }

// Counts are whole numbers that a double holds.
std::vector<double> numbers_of(const schemes::Outcome& of) {
  const auto count = [](long n) { return static_cast<double>(n); };
  std::vector<double> all = {count(of.steps),   count(of.rejections),
                             count(of.sweeps),  count(of.evaluations),
                             count(of.impacts), of.contraction,
                             of.overlap,        of.overlap_at_start,
                             of.travel,         of.energy_change,
                             of.heat,           of.released,
                             of.penetration,    count(of.contacts_at_start)};
  for (const schemes::JumpShare& share : of.jumps_by_law) {
    all.insert(all.end(), {count(share.impacts), share.energy_change});
  }
  return all;
}

// The records of a file whose checksum is right.
class Records {
 public:
  Records(std::string_view bytes, const std::string& origin) : rest_(bytes), origin_(origin) {
    while (!rest_.empty()) read_record();
  }

  std::string text(const std::string& name) const { return std::string(find(name, "text")); }
  std::vector<double> numbers(const std::string& name) const {
    const std::string_view raw = find(name, "real");
    std::vector<double> numbers(raw.size() / sizeof(double));
    if (!numbers.empty()) std::memcpy(numbers.data(), raw.data(), raw.size());
    return numbers;
  }
  Eigen::VectorXd vector(const std::string& name) const {
    const std::vector<double> all = numbers(name);
    return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
  }
  std::map<std::string, std::vector<double>> others() const {
    std::map<std::string, std::vector<double>> all;
    for (const auto& [name, record] : records_) {
      if (name.starts_with(more)) all[name.substr(more.size())] = numbers(name);
    }
    return all;
  }
  [[noreturn]] void refuse() const {
    throw std::runtime_error(fmt::format(
        "{}: its checksum is right, but it does not hold the records of a checkpoint: it was not written by this "
        "program; take one that was, or start anew",
        origin_));
  }

 private:
  struct Record {
    std::string type;
    std::string_view raw;
  };

  std::string word(char end) {
    const std::size_t length = rest_.find(end);
    if (length == std::string_view::npos) refuse();
    const std::string found(rest_.substr(0, length));
    rest_.remove_prefix(length + 1);
    return found;
  }
  void read_record() {
    const std::string name = word(' '), type = word(' '), count = word('\n');
    std::size_t n = 0;
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), n);
    const std::size_t size = type == "real" ? sizeof(double) : 1;
    if (error != std::errc{} || n >= rest_.size() / size + 1 || n * size >= rest_.size()) refuse();
    records_[name] = {type, rest_.substr(0, n * size)};
    rest_.remove_prefix(n * size + 1);
  }
  std::string_view find(const std::string& name, std::string_view type) const {
    const auto found = records_.find(name);
    if (found == records_.end() || found->second.type != type) refuse();
    return found->second.raw;
  }

  std::string_view rest_;
  const std::string& origin_;
  std::map<std::string, Record> records_;
};

schemes::Outcome outcome_from(const Records& records, double t) {
  const std::vector<double> all = records.numbers("outcome");
  if (all.size() < 14 || all.size() % 2 != 0) records.refuse();
  const auto count = [&](std::size_t k) { return static_cast<long>(all[k]); };
  schemes::Outcome outcome{.t = t,
                           .steps = count(0),
                           .rejections = count(1),
                           .sweeps = count(2),
                           .evaluations = count(3),
                           .impacts = count(4),
                           .contraction = all[5],
                           .overlap = all[6],
                           .overlap_at_start = all[7],
                           .contacts_at_start = count(13),
                           .penetration = all[12],
                           .travel = all[8],
                           .energy_change = all[9],
                           .heat = all[10],
                           .released = all[11],
                           .ruled = records.text("ruled")};
  for (std::size_t k = 14; k < all.size(); k += 2) {
    outcome.jumps_by_law.push_back({.impacts = count(k), .energy_change = all[k + 1]});
  }
  return outcome;
}

std::string_view take_line(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  return line;
}

// What stands between the first line and the last.
std::string_view checked(std::string_view bytes, const std::string& origin) {
  const auto refuse = [&](const std::string& why) { throw std::runtime_error(fmt::format("{}: {}", origin, why)); };
  std::string_view rest = bytes;
  const std::string_view first = take_line(rest);
  if (!first.starts_with(kind)) {
    refuse(fmt::format("must begin with \"{}{}{}\", got \"{}\": name a file that a run wrote as its checkpoint", kind,
                       version, order, first.substr(0, 60)));
  }
  const std::string_view after = first.substr(kind.size()), given = after.substr(0, after.find(','));
  if (given != version) {
    refuse(fmt::format(
        "must be a checkpoint of version {}, got version {}: go on with the program that wrote it, or start anew",
        version, given));
  }
  if (after.substr(given.size()) != order) {
    refuse(
        fmt::format("must have the byte order of this machine, \"{}\", got \"{}\": go on where it was written, or "
                    "start anew",
                    order.substr(2), after.substr(std::min(given.size() + 2, after.size()))));
  }
  const std::size_t length = last_line("").size();
  const std::string_view last = rest.size() < length ? rest : rest.substr(rest.size() - length);
  if (last.size() < length || !last.starts_with("checksum ") || !last.ends_with('\n')) {
    refuse(
        "must end with a line with its checksum, and does not: it was cut short; take the one before, or start anew");
  }
  const std::string expected = last_line(bytes.substr(0, bytes.size() - length));
  if (last != expected) {
    refuse(fmt::format("must have the checksum at its end, {}, got {}: it was altered; take another one, or start anew",
                       last.substr(9, 16), expected.substr(9, 16)));
  }
  return rest.substr(0, rest.size() - length);
}

void require_scene(std::string_view theirs, std::string_view ours, const std::string& origin) {
  if (theirs == ours) return;
  int number = 0;
  std::string_view there, here;
  do {
    there = take_line(theirs);
    here = take_line(ours);
    ++number;
  } while (there == here && !(theirs.empty() && ours.empty()));
  throw std::invalid_argument(fmt::format(
      "{}: must be of the same scene, got another one: line {} of what it is made of is \"{}\" there and \"{}\" here. "
      "Give this run what that one had, or start anew",
      origin, number, there, here));
}

}  // namespace

std::string to_bytes(const Checkpoint& checkpoint) {
  const schemes::State& state = checkpoint.state;
  std::string bytes = fmt::format("{}{}{}\n", kind, version, order);
  add(bytes, "scene", checkpoint.scene);
  add(bytes, "engine", checkpoint.engine);
  add(bytes, "time", std::vector<double>{state.t, state.t_carry, checkpoint.step});
  add(bytes, "r", numbers_of(state.r));
  add(bytes, "v", numbers_of(state.v));
  add(bytes, "y", numbers_of(state.y));
  add(bytes, "outcome", numbers_of(checkpoint.outcome));
  add(bytes, "ruled", checkpoint.outcome.ruled);
  for (const auto& [name, numbers] : checkpoint.more) {
    if (name.empty() || name.find_first_of(" \n") != std::string::npos) {
      throw std::invalid_argument(
          fmt::format("checkpoint: names must be words without blanks, got \"{}\": write _ instead", name));
    }
    add(bytes, std::string(more) + name, numbers);
  }
  return bytes + last_line(bytes);
}

Checkpoint checkpoint_from(std::string_view bytes, const std::string& origin, std::string_view scene, Eigen::Index N) {
  const Records records(checked(bytes, origin), origin);
  const std::vector<double> time = records.numbers("time");
  if (time.size() != 3) records.refuse();
  Checkpoint checkpoint{.scene = records.text("scene"),
                        .state = {.t = time[0],
                                  .r = records.vector("r"),
                                  .v = records.vector("v"),
                                  .y = records.vector("y"),
                                  .t_carry = time[1]},
                        .step = time[2],
                        .engine = records.text("engine"),
                        .outcome = outcome_from(records, time[0]),
                        .more = records.others()};
  require_scene(checkpoint.scene, scene, origin);
  if (checkpoint.state.r.size() != 3 * N) {
    throw std::invalid_argument(fmt::format(
        "{}: must be of {} particles, got one of {} numbers for places: go on with as many particles, or start anew",
        origin, N, checkpoint.state.r.size()));
  }
  return checkpoint;
}

void detail::refuse_engine() {
  throw std::invalid_argument(
      "checkpoint: the random engine must be one of the type that wrote the text: take the same, or start anew");
}

}  // namespace particulate::scenes
