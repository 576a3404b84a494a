#include "support/gudhi_persistence.h"

#include <gudhi/Bitmap_cubical_complex.h>
#include <gudhi/Persistent_cohomology.h>

#include <cmath>

namespace volsurf::support {

std::multiset<float> gudhi_persistences(const Field &field)
{
  using Complex =
      Gudhi::cubical_complex::Bitmap_cubical_complex<Gudhi::cubical_complex::Bitmap_cubical_complex_base<double>>;
  using Cohomology =
      Gudhi::persistent_cohomology::Persistent_cohomology<Complex, Gudhi::persistent_cohomology::Field_Zp>;
  std::vector<double> negated;
  for (const float value : field.values)
    negated.push_back(-static_cast<double>(value));
  Complex complex({static_cast<unsigned>(field.size[0]), static_cast<unsigned>(field.size[1]),
                   static_cast<unsigned>(field.size[2])},
                  negated);
  Cohomology cohomology(complex);
  cohomology.init_coefficients(2);
  cohomology.compute_persistent_cohomology(0);

  std::multiset<float> persistences;
  for (const auto &[birth, death] : cohomology.intervals_in_dimension(0))
    if (std::isfinite(death) && death > birth) // the subtraction of the merge, in float32
      persistences.insert(static_cast<float>(-birth) - static_cast<float>(-death));
  return persistences;
}

} // namespace volsurf::support
