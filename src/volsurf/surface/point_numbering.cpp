#include "volsurf/surface/point_numbering.h"

#include "volsurf/core/star.h"

#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"
#include "volsurf/surface/sheets.h"

#include <algorithm>
#include <limits>
#include <string>

namespace volsurf {

namespace {

constexpr std::int64_t kPlanesPerSlab = 16;

/// The star face of `sample` that is the face `face`, whose corner the sample is.
int star_face_at(const FacePosition &face, const Index3 &sample)
{
  const int a = face.axis == 0 ? 1 : 0;
  const int b = face.axis == 2 ? 1 : 2;
  const int high_a = face.corner[a] == sample[a] ? 1 : 0;
  const int high_b = face.corner[b] == sample[b] ? 1 : 0;
  return 4 * face.axis + high_a + 2 * high_b;
}

/// Words of the samples of a row that faces starting at x or x - 1 have as corners.
std::uint64_t with_next(const std::uint64_t *words, std::int64_t w)
{
  return words[w] | words[w] << 1 | (w > 0 ? words[w - 1] >> 63 : 0);
}

} // namespace

PointNumbering::PointNumbering(const FaceSet &faces, const IsInside &is_inside)
    : faces_(faces), words_per_row_(faces.words_per_row()),
      used_(static_cast<std::size_t>(faces.samples()[1] * faces.samples()[2] * words_per_row_)),
      points_before_(used_.size())
{
  mark_used_samples();
  std::uint64_t points = 0;
  for (std::size_t word = 0; word < used_.size(); ++word) {
    points_before_[word] = static_cast<PointId>(points);
    points += static_cast<std::uint64_t>(__builtin_popcountll(used_[word]));
  }
  if (points > std::numeric_limits<PointId>::max() / 2)
    throw Error("the surface has " + std::to_string(points) + " points; at most 2147483647 are allowed: raise delta");
  point_count_ = static_cast<PointId>(points);
  if (is_inside) {
    find_splits(is_inside);
    find_pinched_edges();
  }
}

void PointNumbering::mark_used_samples()
{
  const std::int64_t ny = faces_.samples()[1];
  const std::int64_t nz = faces_.samples()[2];
  parallel_for_slabs(nz, kPlanesPerSlab, [&](const Slab &slab) {
    for (std::int64_t z = slab.begin; z < slab.end; ++z)
      for (std::int64_t y = 0; y < ny; ++y)
        for (std::int64_t w = 0; w < words_per_row_; ++w) {
          std::uint64_t word = 0;
          for (std::int64_t fz = std::max<std::int64_t>(z - 1, 0); fz <= z; ++fz) {
            for (std::int64_t fy = std::max<std::int64_t>(y - 1, 0); fy <= y; ++fy)
              word |= faces_.row(0, fy, fz)[w];
            word |= with_next(faces_.row(1, y, fz), w);
          }
          for (std::int64_t fy = std::max<std::int64_t>(y - 1, 0); fy <= y; ++fy)
            word |= with_next(faces_.row(2, fy, z), w);
          used_[static_cast<std::size_t>((z * ny + y) * words_per_row_ + w)] = word;
        }
  });
}

void PointNumbering::find_splits(const IsInside &is_inside)
{
  const SheetTables &tables = sheet_tables();
  const std::int64_t ny = faces_.samples()[1];
  const std::int64_t nz = faces_.samples()[2];
  std::vector<std::vector<Split>> slabs(static_cast<std::size_t>(slab_count(nz, kPlanesPerSlab)));
  parallel_for_slabs(nz, kPlanesPerSlab, [&](const Slab &slab) {
    for (std::int64_t row = slab.begin * ny; row < slab.end * ny; ++row)
      for (std::int64_t w = 0; w < words_per_row_; ++w)
        for (std::uint64_t rest = used_[static_cast<std::size_t>(row * words_per_row_ + w)]; rest != 0;
             rest &= rest - 1) {
          const Index3 p{64 * w + __builtin_ctzll(rest), row % ny, row / ny};
          const unsigned faces = star_faces(p);
          if (!tables.may_split[faces])
            continue;
          Split split{sample_id(p), 0, {}, 0, 0};
          for (int octant = 0; octant < 8; ++octant)
            if (is_inside({p[0] - 1 + (octant & 1), p[1] - 1 + (octant >> 1 & 1), p[2] - 1 + (octant >> 2)}))
              split.inside = static_cast<std::uint8_t>(split.inside | 1U << octant);
          const auto order_end = [&] { return split.sheet_order.begin() + split.sheet_count; };
          for (int f = 0; f < 12; ++f) {
            const std::uint8_t sheet = tables.sheet[split.inside][f];
            if ((faces >> f & 1U) && std::find(split.sheet_order.begin(), order_end(), sheet) == order_end())
              split.sheet_order[split.sheet_count++] = sheet;
          }
          if (split.sheet_count > 1 || tables.pinched[split.inside] != 0)
            slabs[static_cast<std::size_t>(slab.index)].push_back(split);
        }
  });
  for (const auto &slab : slabs)
    splits_.insert(splits_.end(), slab.begin(), slab.end());
  for (Split &split : splits_) {
    split.first_copy = point_count_;
    point_count_ += split.sheet_count - 1U;
  }
}

void PointNumbering::find_pinched_edges()
{
  const SheetTables &tables = sheet_tables();
  first_midpoint_ = point_count_;
  for (const Split &split : splits_)
    for (int axis = 0; axis < 3; ++axis) {
      if (!(tables.pinched[split.inside] >> (2 * axis + 1) & 1U))
        continue;
      Index3 other = sample_position(split.sample);
      ++other[axis];
      const Split *const end = split_at(sample_id(other));
      if (end != nullptr && (tables.pinched[end->inside] >> (2 * axis) & 1U))
        pinched_.push_back({split.sample, axis});
    }
  point_count_ += static_cast<PointId>(2 * pinched_.size());
}

PointId PointNumbering::corner(const FacePosition &face, const Index3 &corner) const
{
  const Split *const split = splits_.empty() ? nullptr : split_at(sample_id(corner));
  if (split == nullptr)
    return own_point(corner);
  const std::uint8_t sheet = sheet_tables().sheet[split->inside][star_face_at(face, corner)];
  const auto *const found = std::find(split->sheet_order.begin(), split->sheet_order.end(), sheet);
  const auto copy = static_cast<PointId>(found - split->sheet_order.begin());
  return copy == 0 ? own_point(corner) : split->first_copy + copy - 1;
}

bool PointNumbering::has_midpoint(const Index3 &sample, int axis) const
{
  return !pinched_.empty() && pinched_edge(sample_id(sample), axis) != nullptr;
}

PointId PointNumbering::midpoint(const FacePosition &face, const Index3 &sample, int axis) const
{
  // The edge's four octants hold two inside ones; the face's own tells which of the two midpoints is its.
  const unsigned inside = split_at(sample_id(sample))->inside;
  const int star_face = star_face_at(face, sample);
  const int own = (inside >> lower_octant(star_face) & 1U) ? lower_octant(star_face) : upper_octant(star_face);
  int lowest = 1 << axis;
  while (!(inside >> lowest & 1U) || !(lowest >> axis & 1))
    ++lowest;
  const auto edge = static_cast<PointId>(pinched_edge(sample_id(sample), axis) - pinched_.data());
  return first_midpoint_ + 2 * edge + (own == lowest ? 0 : 1);
}

void PointNumbering::for_each_point(const std::function<void(PointId, const Vec3 &)> &visit) const
{
  const std::int64_t ny = faces_.samples()[1];
  const std::int64_t nz = faces_.samples()[2];
  const auto as_position = [](const Index3 &p) {
    return Vec3{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  };
  parallel_for_slabs(ny * nz, 256, [&](const Slab &rows) {
    for (std::int64_t row = rows.begin; row < rows.end; ++row)
      for (std::int64_t w = 0; w < words_per_row_; ++w) {
        const auto word = static_cast<std::size_t>(row * words_per_row_ + w);
        PointId point = points_before_[word];
        for (std::uint64_t rest = used_[word]; rest != 0; rest &= rest - 1)
          visit(point++, as_position({64 * w + __builtin_ctzll(rest), row % ny, row / ny}));
      }
  });
  for (const Split &split : splits_)
    for (PointId copy = 1; copy < split.sheet_count; ++copy)
      visit(split.first_copy + copy - 1, as_position(sample_position(split.sample)));
  for (std::size_t edge = 0; edge < pinched_.size(); ++edge) {
    Vec3 middle = as_position(sample_position(pinched_[edge].sample));
    middle[pinched_[edge].axis] += 0.5;
    for (PointId side = 0; side < 2; ++side)
      visit(first_midpoint_ + 2 * static_cast<PointId>(edge) + side, middle);
  }
}

const PointNumbering::Split *PointNumbering::split_at(SampleId sample) const
{
  const auto found = std::lower_bound(splits_.begin(), splits_.end(), sample,
                                      [](const Split &split, SampleId id) { return split.sample < id; });
  return found != splits_.end() && found->sample == sample ? &*found : nullptr;
}

const PointNumbering::PinchedEdge *PointNumbering::pinched_edge(SampleId sample, int axis) const
{
  const auto found = std::lower_bound(pinched_.begin(), pinched_.end(), PinchedEdge{sample, axis},
                                      [](const PinchedEdge &a, const PinchedEdge &b) {
                                        return a.sample != b.sample ? a.sample < b.sample : a.axis < b.axis;
                                      });
  return found != pinched_.end() && found->sample == sample && found->axis == axis ? &*found : nullptr;
}

unsigned PointNumbering::star_faces(const Index3 &sample) const
{
  unsigned faces = 0;
  for (int f = 0; f < 12; ++f) {
    Index3 p = sample;
    const int axis = f / 4;
    p[axis == 0 ? 1 : 0] -= 1 - (f & 1);
    p[axis == 2 ? 1 : 2] -= 1 - (f >> 1 & 1);
    faces |= static_cast<unsigned>(faces_.contains(axis, p[0], p[1], p[2])) << f;
  }
  return faces;
}

SampleId PointNumbering::sample_id(const Index3 &p) const
{
  return (p[2] * faces_.samples()[1] + p[1]) * faces_.samples()[0] + p[0];
}

Index3 PointNumbering::sample_position(SampleId sample) const
{
  const auto &[nx, ny, nz] = faces_.samples();
  return {sample % nx, sample / nx % ny, sample / nx / ny};
}

PointId PointNumbering::own_point(const Index3 &p) const
{
  const auto word = static_cast<std::size_t>((p[2] * faces_.samples()[1] + p[1]) * words_per_row_ + (p[0] >> 6));
  const std::uint64_t before = used_[word] & ((std::uint64_t{1} << (p[0] & 63)) - 1);
  return points_before_[word] + static_cast<PointId>(__builtin_popcountll(before));
}

} // namespace volsurf
