// volsurf_compute: times volsurf from the gradient to the components, in memory; prints JSON.
#include "benchmark/volsurf_run.h"

int main(int argc, char **argv)
{
  using namespace volsurf::bench;
  CLI::App app("Times volsurf from the gradient to the components, without reading and writing.", "volsurf_compute");
  RunOptions options;
  bool with_mesh = false;
  add_run_options(app, options);
  app.add_flag("--mesh", with_mesh, "Make the triangles as well");
  return run_program(app, argc, argv, [&] {
    measure_and_print(options,
                      [&](const auto &volume, const auto &run) { return run_volsurf(volume, run, with_mesh); });
  });
}
