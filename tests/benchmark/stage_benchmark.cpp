// stage_benchmark [FILE] [Google Benchmark's options]: each stage by itself, per sample of the volume.
//
// The volumes are head phantoms with 2 % of impulses, and FILE if it is given. Delta is a tenth of the largest
// persistence, so that each volume has a surface. What a stage consumes is made anew outside of its time. Google
// Benchmark's warning that Debian built it as DEBUG can be passed over: stages take milliseconds.
#include "volsurf/core/parallel.h"
#include "volsurf/field/gradient.h"
#include "volsurf/io/read_volume.h"
#include "volsurf/phantom/noise.h"
#include "volsurf/phantom/phantom.h"
#include "volsurf/surface/boundary.h"
#include "volsurf/surface/check.h"
#include "volsurf/surface/components.h"
#include "volsurf/surface/extract.h"
#include "volsurf/surface/smoothing.h"
#include "volsurf/topology/region_merge.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <utility>

namespace {

using namespace volsurf;

Volume noisy_phantom(std::int64_t size)
{
  PhantomOptions options;
  options.size = {size, size, size};
  options.spacing_mm = spacing_that_fits_the_head(options.size);
  options.with_truth = false;
  Volume volume = make_head_phantom(options).volume;
  add_noise(volume, parse_noise("impulse:2%", kTissueContrast));
  return volume;
}

/// I of all samples.
std::vector<float> whole_field(const EdgeField &field, const Grid &grid)
{
  std::vector<float> values(static_cast<std::size_t>(grid.sample_count()));
  parallel_for_slabs(grid.size[2], large_slab(grid.size[2]), [&](const Slab &slab) {
    for (std::int64_t z = slab.begin; z < slab.end; ++z)
      field.plane(z, values.data() + z * grid.size[0] * grid.size[1]);
  });
  return values;
}

PlaneSource planes_of(const std::vector<float> &values, const Index3 &size)
{
  return [&values, nx = size[0], ny = size[1]](std::int64_t z, const RowRange &rows, float *out) {
    std::copy_n(values.data() + (z * ny + rows.begin) * nx, rows.count() * nx, out);
  };
}

/// A volume with what each stage makes of it.
struct Stages {
  explicit Stages(Volume v)
      : volume(std::move(v)), plain(volume, {0.0, false}), smoothed(volume, {}),
        values(whole_field(smoothed, volume.grid)), source(planes_of(values, volume.grid.size)),
        merge(merge_regions(volume.grid.size, source, {})),
        delta(0.1 * static_cast<double>(merge.hierarchy.largest_persistence())), regions(cut(merge.hierarchy, delta)),
        background(regions.of_basin[merge.hierarchy.background]), sides{regions.of_basin, 0}
  {
    std::replace(sides.of_basin.begin(), sides.of_basin.end(), background, RegionId{0});
    FaceSet faces = boundary();
    const Components components = find_components(faces, volume.grid, {});
    kept = keep_components(std::move(faces), components);
    mesh = extract();
  }

  TileSize tile() const { return default_tile_size(volume.grid.size); }
  StarSweep sweep() const { return sweep_stars(volume.grid.size, source, Exterior::none, tile(), {}); }
  Basins label(StarSweep &input) const { return label_basins(cells(), input, Exterior::none, tile().planes); }
  BasinTree join(const Basins &basins, StarSweep &input) const
  {
    return join_saddles(cells(), basins, input, tile().planes);
  }
  CellGrid cells() const { return CellGrid(merge.cells.size); }
  FaceSet boundary() const { return find_boundary(merge.cells, sides); }

  Mesh extract() const
  {
    const RegionsOfCells regions_of_cells{merge.cells, regions.of_basin, background, merge.hierarchy.background,
                                          [&](BasinId a, BasinId b) { return saliency(merge.hierarchy, a, b); }};
    return extract_mesh(kept, volume.grid, sides, regions_of_cells, false);
  }

  Volume volume;
  EdgeField plain;
  EdgeField smoothed;
  std::vector<float> values;
  PlaneSource source;
  RegionMerge merge;
  double delta;
  Regions regions;
  RegionId background;
  Sides sides;
  KeptFaces kept{FaceSet({1, 1, 1}), {}};
  Mesh mesh;
};

using StageBenchmark = void (*)(benchmark::State &, const Stages &);

void gradient_sigma_0(benchmark::State &state, const Stages &stages)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(whole_field(stages.plain, stages.volume.grid));
}

void gradient_one_voxel(benchmark::State &state, const Stages &stages)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(whole_field(stages.smoothed, stages.volume.grid));
}

void sweep(benchmark::State &state, const Stages &stages)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(stages.sweep());
}

void labels(benchmark::State &state, const Stages &stages)
{
  for (auto _ : state) {
    state.PauseTiming();
    StarSweep input = stages.sweep();
    state.ResumeTiming();
    benchmark::DoNotOptimize(stages.label(input));
  }
}

void saddles(benchmark::State &state, const Stages &stages)
{
  for (auto _ : state) {
    state.PauseTiming();
    StarSweep input = stages.sweep();
    const Basins basins = stages.label(input);
    state.ResumeTiming();
    benchmark::DoNotOptimize(stages.join(basins, input));
  }
}

void hierarchy(benchmark::State &state, const Stages &stages)
{
  for (auto _ : state) {
    state.PauseTiming();
    StarSweep input = stages.sweep();
    Basins basins = stages.label(input);
    BasinTree tree = stages.join(basins, input);
    state.ResumeTiming();
    benchmark::DoNotOptimize(make_hierarchy(basins, tree, Exterior::none));
  }
  state.counters["basins"] = static_cast<double>(stages.merge.hierarchy.basin_count());
}

void cut_at_delta(benchmark::State &state, const Stages &stages)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(cut(stages.merge.hierarchy, stages.delta));
  state.counters["regions"] = static_cast<double>(stages.regions.count());
}

void boundary(benchmark::State &state, const Stages &stages)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(stages.boundary());
}

void components(benchmark::State &state, const Stages &stages)
{
  const FaceSet faces = stages.boundary();
  for (auto _ : state)
    benchmark::DoNotOptimize(find_components(faces, stages.volume.grid, {}));
  state.counters["faces"] = faces.size();
}

void extract(benchmark::State &state, const Stages &stages)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(stages.extract());
  state.counters["triangles"] = static_cast<double>(stages.mesh.triangles.size());
}

void check(benchmark::State &state, const Stages &stages)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(check_mesh(stages.mesh));
}

void smooth(benchmark::State &state, const Stages &stages)
{
  for (auto _ : state) {
    state.PauseTiming();
    Mesh mesh = stages.mesh;
    state.ResumeTiming();
    benchmark::DoNotOptimize(smooth_mesh(mesh, stages.volume.grid, {}));
  }
}

constexpr std::pair<const char *, StageBenchmark> kStages[] = {
    {"gradient_sigma_0", gradient_sigma_0},
    {"gradient_one_voxel", gradient_one_voxel},
    {"sweep_stars", sweep},
    {"label_basins", labels},
    {"join_saddles", saddles},
    {"make_hierarchy", hierarchy},
    {"cut", cut_at_delta},
    {"find_boundary", boundary},
    {"find_components", components},
    {"extract_mesh", extract},
    {"check_mesh", check},
    {"smooth_mesh", smooth},
};

/// The last volume asked for. Benchmarks run in the order in which they are registered, one volume after the other.
const Stages &stages_of(const std::string &name, const std::function<Volume()> &load)
{
  static std::string current;
  static std::unique_ptr<Stages> stages;
  if (current != name) {
    stages.reset();
    stages = std::make_unique<Stages>(load());
    current = name;
  }
  return *stages;
}

void register_volume(const std::string &volume, const std::function<Volume()> &load)
{
  for (const auto &[stage, run] : kStages)
    benchmark::RegisterBenchmark((volume + "/" + stage).c_str(),
                                 [=, run = run](benchmark::State &state) {
                                   const ThreadLimit limit(static_cast<int>(state.range(0)));
                                   const Stages &stages = stages_of(volume, load);
                                   run(state, stages);
                                   const std::int64_t samples = stages.volume.grid.sample_count();
                                   state.SetItemsProcessed(state.iterations() * samples);
                                   state.counters["per_sample"] = benchmark::Counter(
                                       static_cast<double>(samples),
                                       benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
                                 })
        ->ArgName("threads")
        ->Arg(1)
        ->Arg(2)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
}

} // namespace

int main(int argc, char **argv)
{
  benchmark::Initialize(&argc, argv);
  if (argc > 2) {
    std::cerr << "usage: stage_benchmark [FILE] [--benchmark_filter=REGEX] [--benchmark_...]\n";
    return 2;
  }
  for (const std::int64_t size : {64, 128, 256})
    register_volume("phantom_" + std::to_string(size), [=] { return noisy_phantom(size); });
  if (argc == 2)
    register_volume(std::filesystem::path(argv[1]).filename().string(),
                    [path = std::filesystem::path(argv[1])] { return read_volume(path).volume; });
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
