// The small works: one function of the course each, called for many inputs with any number.
#pragma once
#include <array>
#include <atomic>
#include <memory>
#include <tuple>
#include <variant>

#include "engine/kernels/kernel_plan.hpp"
#include "engine/kernels/srgb_kernel.hpp"
#include "published/uv.hpp"
#include "variants.hpp"

namespace texmap::bench {

/// Columns of numbers, each both in float and in double.
class Columns {
 public:
  /// @param rows  a multiple of 16, the most lanes that a pack has
  Columns(std::size_t count, std::size_t rows)
      : rows_(rows),
        numbers_(std::vector<float>(count * rows), std::vector<double>(count * rows)) {}

  [[nodiscard]] std::size_t rows() const { return rows_; }
  /// The numbers of a column, as T: float or double.
  template <class T>
  [[nodiscard]] T* at(std::size_t column) {
    return std::get<std::vector<T>>(numbers_).data() + column * rows_;
  }
  void set(std::size_t column, std::size_t row, double value) {
    at<double>(column)[row] = value;
    at<float>(column)[row] = static_cast<float>(value);
  }

 private:
  std::size_t rows_;
  std::tuple<std::vector<float>, std::vector<double>> numbers_;
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

template <class Real, std::size_t Count>
[[nodiscard]] Vec3<Real> vector_in(const std::array<Real, Count>& in, std::size_t first = 0) {
  return {in[first], in[first + 1], in[first + 2]};
}

/// (u, v) of unit vectors: by the polynomial of a degree, by trigonometry for 0, by Next Week's
/// formula for -1.
struct UvFunction {
  static constexpr std::size_t inputs = 3, outputs = 2;
  int degree;

  template <class Real>
  void visit(const auto& use) const {
    const auto map = [&](const auto& mapping) {
      use([&](const auto& in, std::size_t) {
        const Uv<Real> uv = mapping(vector_in(in));
        return std::array{uv.u, uv.v};
      });
      return true;
    };
    if (degree >= 0)
      static_cast<void>(with_uv_mapping(degree, map));
    else if constexpr (lanes<Real> == 1)
      map([](const Vec3<Real>& p) { return published::uv_next_week_v4(p); });
  }
};

/// Colors of a texture at given (u, v); their sum is kept.
struct TextureFunction {
  static constexpr std::size_t inputs = 2, outputs = 1;
  std::shared_ptr<const LightTexture> exact;
  PlannedTexture texture;

  template <class Real>
  void visit(const auto& use) const {
    use([&](const auto& in, std::size_t) {
      const Color<Real> color = texture(Uv<Real>{in[0], in[1]});
      return std::array{color.r + color.g + color.b};
    });
  }
};

/// Distances to a sphere from origins in directions.
struct SphereFunction {
  static constexpr std::size_t inputs = 6, outputs = 1;
  Sphere<> sphere;

  template <class Real>
  void visit(const auto& use) const {
    use([&](const auto& in, std::size_t) {
      return std::array{distance_to(sphere, Ray<Real>{vector_in(in), vector_in(in, 3)})};
    });
  }
};

/// Bytes of amounts of light, by the sRGB curve: a polynomial of 3 or 4 terms, the exact kernel for
/// 0, the formula's power for -1.
struct EncodeFunction {
  static constexpr std::size_t inputs = 1, outputs = 1;
  int terms;

  template <class Real>
  void visit(const auto& use) const {
    const auto convert = [&](const auto& byte_of_light) {
      use([&](const auto& in, std::size_t) { return std::array{byte_of_light(in[0])}; });
    };
    if (terms == 3) convert([](const Real& x) { return srgb_byte<3>(x); });
    if (terms == 4) convert([](const Real& x) { return srgb_byte<4>(x); });
    if (terms == 0) convert([](const Real& x) { return srgb_byte_exact(x); });
    if constexpr (lanes<Real> == 1) {
      if (terms < 0)
        convert(
            [](const Real& x) -> Real { return floor(srgb_encode(x) * Real(255) + Real(0.5)); });
    }
  }
};

/// Phong's power of an angle, from 1 - cos: a polynomial of 3, 4, 6 or 8 terms, the formula of
/// `highlight` for 0.
struct PowerFunction {
  static constexpr std::size_t inputs = 1, outputs = 1;
  int terms;
  double exponent = 50;

  template <class Real>
  void visit(const auto& use) const {
    const auto raise = [&](const auto& power) {
      use([&](const auto& in, std::size_t) { return std::array<Real, 1>{power(in[0])}; });
    };
    if (terms == 0) {
      raise([n = exponent](const Real& versine) {
        return exp(Real(n) * log1p(-clamp(versine, Real(0), below_one<Real>())));
      });
    }
    if (terms == 3) raise(PowerKernel<3>(exponent));
    if (terms == 4) raise(PowerKernel<4>(exponent));
    if (terms == 6) raise(PowerKernel<6>(exponent));
    if (terms == 8) raise(PowerKernel<8>(exponent));
  }
};

/// What is called for every row of an input. Each has visit<Real>(use), which gives use() something
/// that makes `outputs` numbers of `inputs` and of the row's number.
using Function =
    std::variant<UvFunction, TextureFunction, SphereFunction, EncodeFunction, PowerFunction>;

/// A function and its input: a work of draw.hpp with float, double, and single packs of them.
struct Job {
  using Result = void;

  Function function;
  int repeats;
  mutable Columns input, output;

  Job(Function wanted, std::size_t rows, int times)
      : function(std::move(wanted)), repeats(times), input(most_inputs, rows), output(2, rows) {}

  template <class Real>
  void run() const {
    if constexpr (requires(Real pair) { pair.second; }) {
      run<decltype(Real::first)>();
    } else if constexpr (!std::is_same_v<Real, long double>) {
      std::visit([this](const auto& one) { this->calculate<Real>(one); }, function);
    }
  }
  void run(const Variant& variant) const;  ///< not inline: files of wide packs would compile it

 private:
  static constexpr std::size_t most_inputs = 6;

  template <class Real, class One>
  void calculate(const One& one) const {
    using T = Scalar<Real>;
    one.template visit<Real>([&](const auto& numbers_of) {
      for (int repeat = 0; repeat < repeats; ++repeat) {
        for (std::size_t row = 0; row < input.rows(); row += lanes<Real>) {
          std::array<Real, One::inputs> in;
          for (std::size_t i = 0; i < in.size(); ++i) in[i] = load<Real>(input.at<T>(i) + row);
          const std::array<Real, One::outputs> out = numbers_of(in, row);
          for (std::size_t i = 0; i < out.size(); ++i) store(out[i], output.at<T>(i) + row);
        }
        // The compiler must take each time for a new one.
        std::atomic_signal_fence(std::memory_order_seq_cst);
      }
    });
  }
};

}  // namespace texmap::bench
