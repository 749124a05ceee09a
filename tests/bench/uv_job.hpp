// (u, v) of many unit vectors, with any number.
#pragma once
#include <array>
#include <atomic>
#include <tuple>

#include "engine/fast/kernel_plan.hpp"
#include "published/uv.hpp"
#include "variants.hpp"

namespace texmap::bench {

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

/// A work of draw.hpp with float, double, and single packs of them.
struct UvJob {
  using Result = void;
  static constexpr bool for_packs = true;
  static constexpr std::size_t rows = 512;  ///< so few that all stay in the first cache
  static constexpr int repeats = 32;

  template <class T>
  struct Columns {
    std::array<T, rows> x, y, z, u, v;
  };

  int degree;  ///< of the polynomial; 0: by trigonometry; -1: by Next Week's formula
  mutable std::tuple<Columns<float>, Columns<double>> columns{};

  template <class Real>
  void run() const {
    if constexpr (requires(Real pair) { pair.second; }) {
      run<decltype(Real::first)>();
    } else if constexpr (!std::is_same_v<Real, long double>) {
      const auto map = [this](const auto& mapping) {
        this->map_all<Real>(mapping);
        return true;
      };
      if (degree >= 0)
        static_cast<void>(with_uv_mapping(degree, map));
      else if constexpr (lanes<Real> == 1)
        map([](const Vec3<Real>& p) { return published::uv_next_week_v4(p); });
    }
  }
  void run(const Variant& variant) const;  ///< not inline: files of wide packs would compile it

 private:
  template <class Real, class Mapping>
  void map_all(const Mapping& mapping) const {
    auto& [x, y, z, u, v] = std::get<Columns<Scalar<Real>>>(columns);
    for (int repeat = 0; repeat < repeats; ++repeat) {
      for (std::size_t row = 0; row < rows; row += lanes<Real>) {
        const Uv<Real> uv =
            mapping(Vec3<Real>{load<Real>(&x[row]), load<Real>(&y[row]), load<Real>(&z[row])});
        store(uv.u, &u[row]);
        store(uv.v, &v[row]);
      }
      // The compiler must take each time for a new one.
      std::atomic_signal_fence(std::memory_order_seq_cst);
    }
  }
};

}  // namespace texmap::bench
