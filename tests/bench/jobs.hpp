// The small works: one function of the course each, called for many inputs with any number.
#pragma once
#include <atomic>
#include <cstddef>
#include <vector>

#include "engine/kernels/kernel_plan.hpp"
#include "engine/kernels/srgb_kernel.hpp"
#include "published/uv.hpp"
#include "sampling/samplers.hpp"
#include "support/whole_numbers.hpp"
#include "texture/checkerboard.hpp"
#include "texture/mapped.hpp"

namespace texmap::bench {

/// Columns of numbers, each both in float and in double.
class Columns {
 public:
  /// @param rows  a multiple of 16, the most lanes that a pack has
  Columns(std::size_t count, std::size_t rows)
      : rows_(rows), singles_(count * rows), doubles_(count * rows) {}

  [[nodiscard]] std::size_t rows() const { return rows_; }
  /// The numbers of a column, as T: float or double.
  template <class T>
  [[nodiscard]] T* at(std::size_t column) {
    if constexpr (sizeof(T) == sizeof(float)) {
      return singles_.data() + column * rows_;
    } else {
      return doubles_.data() + column * rows_;
    }
  }
  void set(std::size_t column, std::size_t row, double value) {
    at<double>(column)[row] = value;
    at<float>(column)[row] = static_cast<float>(value);
  }

 private:
  std::size_t rows_;
  std::vector<float> singles_;
  std::vector<double> doubles_;
};

/// The numbers that begin at `from`, one for each lane.
template <class Real>
[[nodiscard]] Real load(const Scalar<Real>* from) {
  if constexpr (lanes<Real> == 1) {
    return *from;
  } else if constexpr (requires { Real::Batch::load_unaligned(from); }) {
    return Real::Batch::load_unaligned(from);
  } else {
    return from_lanes<Real>([from](std::size_t i) { return from[i]; });
  }
}
template <class Real>
void store(const Real& value, Scalar<Real>* to) {
  if constexpr (lanes<Real> == 1) {
    *to = value;
  } else {
    value.batch().store_unaligned(to);
  }
}

/// Calls `work(row)` for each row, `repeats` times over; the compiler must take each time for a new
/// one.
template <class Real, class Function>
void for_each_pack(std::size_t rows, int repeats, const Function& work) {
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (std::size_t row = 0; row < rows; row += lanes<Real>) work(row);
    std::atomic_signal_fence(std::memory_order_seq_cst);
  }
}

/// The vector in three columns, from `first` on.
template <class Real>
[[nodiscard]] Vec3<Real> vector_at(Columns& columns, std::size_t first, std::size_t row) {
  using T = Scalar<Real>;
  return {load<Real>(columns.at<T>(first) + row), load<Real>(columns.at<T>(first + 1) + row),
          load<Real>(columns.at<T>(first + 2) + row)};
}

/// (u, v) of unit vectors.
struct UvJob {
  enum Formula { next_week, stable, polynomial };
  Formula formula;
  int degree;      ///< of the polynomial: 5, 9, 13, 17 in float, 23, 29, 35 in double
  Columns* input;  ///< x, y, z
  Columns* output;
  int repeats;

  template <class Real>
  void run() const {
    if (formula == stable) return map<Real>(RtiowMapping{});
    if (formula == next_week) {
      if constexpr (lanes<Real> == 1)
        map<Real>([](const Vec3<Real>& p) { return published::uv_next_week_v4(p); });
      return;
    }
    if constexpr (sizeof(Scalar<Real>) == sizeof(float)) {
      if (degree == 5) map<Real>(FastUnitMapping<5>{});
      if (degree == 9) map<Real>(FastUnitMapping<9>{});
      if (degree == 13) map<Real>(FastUnitMapping<13>{});
      if (degree == 17) map<Real>(FastUnitMapping<17>{});
    } else {
      if (degree == 23) map<Real>(FastUnitMapping<23>{});
      if (degree == 29) map<Real>(FastUnitMapping<29>{});
      if (degree == 35) map<Real>(FastUnitMapping<35>{});
    }
  }

 private:
  template <class Real, class Mapping>
  void map(const Mapping& mapping) const {
    using T = Scalar<Real>;
    for_each_pack<Real>(input->rows(), repeats, [&](std::size_t row) {
      const Uv<Real> uv = mapping(vector_at<Real>(*input, 0, row));
      store(uv.u, output->at<T>(0) + row);
      store(uv.v, output->at<T>(1) + row);
    });
  }
};

/// Colors of a texture at given (u, v); their sum is kept.
struct TextureJob {
  const PlannedTexture* texture;
  Columns* input;  ///< u, v
  Columns* output;

  template <class Real>
  void run() const {
    using T = Scalar<Real>;
    for_each_pack<Real>(input->rows(), 1, [&](std::size_t row) {
      const Uv<Real> uv = {load<Real>(input->at<T>(0) + row), load<Real>(input->at<T>(1) + row)};
      const Color<Real> color = (*texture)(uv);
      store(color.r + color.g + color.b, output->at<T>(0) + row);
    });
  }
};

/// Distances to a sphere.
struct SphereJob {
  Sphere<> sphere;
  Columns* input;  ///< origin, direction
  Columns* output;
  int repeats;

  template <class Real>
  void run() const {
    using T = Scalar<Real>;
    for_each_pack<Real>(input->rows(), repeats, [&](std::size_t row) {
      const Ray<Real> ray = {vector_at<Real>(*input, 0, row), vector_at<Real>(*input, 3, row)};
      store(distance_to(sphere, ray), output->at<T>(0) + row);
    });
  }
};

/// Pairs of numbers of the samples of some pixels; their sum is kept.
struct SamplerJob {
  const Sampler* sampler;
  Columns* output;  ///< a row for each pixel

  template <class Real>
  void run() const {
    using T = Scalar<Real>;
    sampler->visit([&](const auto& pattern) {
      for_each_pack<Real>(output->rows(), 1, [&](std::size_t pixel) {
        const UInt<Real> pixels = test::hash_row<Real>(static_cast<std::uint32_t>(pixel), 7);
        Real sum = Real(0);
        for (std::uint32_t sample = 0; sample < static_cast<std::uint32_t>(sampler->samples());
             ++sample) {
          const Point2<Real> pair = pattern.template pair<Real>(pixels, sample, 3);
          sum = sum + pair.u * pair.v;
        }
        store(sum, output->at<T>(0) + pixel);
      });
    });
  }
};

/// Bytes of amounts of light, by the sRGB curve.
struct EncodeJob {
  int terms;       ///< 3, 4 or 6 of the polynomial, 0: the exact kernel, -1: the formula's power
  Columns* input;  ///< light, 0 to 1
  Columns* output;
  int repeats;

  template <class Real>
  void run() const {
    if (terms == 3) convert<Real>([](const Real& x) { return srgb_byte<3>(x); });
    if (terms == 4) convert<Real>([](const Real& x) { return srgb_byte<4>(x); });
    if (terms == 6) convert<Real>([](const Real& x) { return srgb_byte<6>(x); });
    if (terms == 0) convert<Real>([](const Real& x) { return srgb_byte_exact(x); });
    if constexpr (lanes<Real> == 1) {
      if (terms < 0)
        convert<Real>([](const Real& x) { return floor(srgb_encode(x) * Real(255) + Real(0.5)); });
    }
  }

 private:
  template <class Real, class Function>
  void convert(const Function& function) const {
    using T = Scalar<Real>;
    for_each_pack<Real>(input->rows(), repeats, [&](std::size_t row) {
      store(function(load<Real>(input->at<T>(0) + row)), output->at<T>(0) + row);
    });
  }
};

/// Phong's power of an angle, from 1 - cos.
struct PowerJob {
  double exponent;
  int terms;       ///< 3, 4, 6 or 8 of the polynomial, 0 for the formula of `highlight`
  Columns* input;  ///< 1 - cos, 0 to 1
  Columns* output;
  int repeats;

  template <class Real>
  void run() const {
    if (terms == 0) {
      return raise<Real>([n = exponent](const Real& versine) {
        return exp(Real(n) * log1p(-clamp(versine, Real(0), below_one<Real>())));
      });
    }
    if (terms == 3) raise<Real>(PowerKernel<3>(exponent));
    if (terms == 4) raise<Real>(PowerKernel<4>(exponent));
    if (terms == 6) raise<Real>(PowerKernel<6>(exponent));
    if (terms == 8) raise<Real>(PowerKernel<8>(exponent));
  }

 private:
  template <class Real, class Function>
  void raise(const Function& function) const {
    using T = Scalar<Real>;
    for_each_pack<Real>(input->rows(), repeats, [&](std::size_t row) {
      store(function(load<Real>(input->at<T>(0) + row)), output->at<T>(0) + row);
    });
  }
};

/// The squares of a checkerboard on a globe, by uv_rtiow.
struct CheckerJob {
  Columns* input;  ///< unit vectors: x, y, z
  Columns* output;
  int repeats;

  template <class Real>
  void run() const {
    using T = Scalar<Real>;
    const Checkerboard texture{.even = {1, 1, 1}, .odd = {0, 0, 0}, .squares = 10};
    for_each_pack<Real>(input->rows(), repeats, [&](std::size_t row) {
      const Uv<Real> uv = uv_rtiow(vector_at<Real>(*input, 0, row));
      store(texture(uv).r, output->at<T>(0) + row);
    });
  }
};

}  // namespace texmap::bench
