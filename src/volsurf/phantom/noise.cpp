#include "volsurf/phantom/noise.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"
#include "volsurf/phantom/random.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace volsurf {

namespace {

constexpr std::int64_t kSamplesPerSlab = 1 << 16;

struct NormalPair {
  double first;
  double second;
};

/// Two independent standard normal values for a sample, by Box and Muller.
NormalPair random_normals(std::uint64_t seed, std::uint64_t sample)
{
  const double radius = std::sqrt(-2 * std::log(1 - random_uniform(seed, 2 * sample)));
  const double angle = 6.283185307179586 * random_uniform(seed, 2 * sample + 1);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Sets each sample to value(sample, old value).
template <typename Value> void replace_samples(Volume &volume, const Value &value)
{
  const auto count = static_cast<std::int64_t>(volume.samples.size());
  parallel_for_slabs(count, kSamplesPerSlab, [&](const Slab &slab) {
    for (std::int64_t i = slab.begin; i < slab.end; ++i) {
      float &sample = volume.samples[static_cast<std::size_t>(i)];
      sample = static_cast<float>(value(static_cast<std::uint64_t>(i), sample));
    }
  });
}

void add_impulses(Volume &volume, double fraction, std::uint64_t seed)
{
  if (volume.samples.empty())
    return;
  const auto [low, high] = std::minmax_element(volume.samples.begin(), volume.samples.end());
  const double base = *low;
  const double range = static_cast<double>(*high) - base;
  replace_samples(volume, [=](std::uint64_t i, double old) {
    return random_uniform(seed, 2 * i) < fraction ? base + range * random_uniform(seed, 2 * i + 1) : old;
  });
}

bool is_allowed(NoiseKind kind, double amount)
{
  return amount >= 0 && amount <= (kind == NoiseKind::kImpulse ? 1.0 : std::numeric_limits<double>::max());
}

NoiseKind kind_of_name(std::string_view name)
{
  if (name == "impulse")
    return NoiseKind::kImpulse;
  if (name == "gaussian")
    return NoiseKind::kGaussian;
  return name == "rician" ? NoiseKind::kRician : NoiseKind::kNone;
}

} // namespace

void add_noise(Volume &volume, const NoiseOptions &options)
{
  if (options.kind == NoiseKind::kNone)
    return;
  if (!is_allowed(options.kind, options.amount))
    throw UsageError("noise: amount " + std::to_string(options.amount) + " is out of range");
  const double sd = options.amount;
  const std::uint64_t seed = options.seed;
  if (options.kind == NoiseKind::kImpulse)
    add_impulses(volume, options.amount, seed);
  else if (options.kind == NoiseKind::kGaussian)
    replace_samples(volume, [=](std::uint64_t i, double old) { return old + sd * random_normals(seed, i).first; });
  else
    replace_samples(volume, [=](std::uint64_t i, double old) {
      const NormalPair normals = random_normals(seed, i);
      return std::hypot(old + sd * normals.first, sd * normals.second);
    });
}

NoiseOptions parse_noise(std::string_view text, double contrast)
{
  NoiseOptions options;
  if (text == "none")
    return options;
  const std::size_t colon = std::min(text.find(':'), text.size());
  options.kind = kind_of_name(text.substr(0, colon));
  std::string_view number = text.substr(std::min(colon + 1, text.size()));
  const bool percent = !number.empty() && number.back() == '%';
  number.remove_suffix(percent ? 1 : 0);
  const char *end = number.data() + number.size();
  const auto [stop, error] = std::from_chars(number.data(), end, options.amount);
  if (percent)
    options.amount *= (options.kind == NoiseKind::kImpulse ? 1 : contrast) / 100;
  if (options.kind == NoiseKind::kNone || error != std::errc() || stop != end ||
      !is_allowed(options.kind, options.amount))
    throw UsageError("noise: \"" + std::string(text) +
                     "\" is not none, impulse:FRACTION with 0 .. 1 or 0% .. 100%, gaussian:SD or rician:SD with an " +
                     "intensity or a percentage, 0 or more");
  return options;
}

} // namespace volsurf
