// Polynomials for the kernels, as tools/fit_kernels.cpp finds them; a test checks that they are the
// best.
#pragma once
#include <array>

// clang-format off
namespace texmap::fits {

// `powers` holds the coefficients, the lowest power first. `worst` is the largest error with exact
// arithmetic. `rounding` bounds what rounding adds to it, in epsilons, as tests/proofs proves for
// float, double and 80-bit long double.

/// atan(t) / (2 pi t) by powers of t^2, for t from 0 to 1. `worst` is in turns of the angle.
template <int Terms>
struct ArcTangent;
template <> struct ArcTangent<3> {
  static constexpr double worst = 9.7e-05, rounding = 0.28;
  static constexpr std::array<long double, 3> powers = {
      1.58416138641722169234e-01L, -4.59464783980314565038e-02L, 1.26272006199542793525e-02L};
};
template <> struct ArcTangent<5> {
  static constexpr double worst = 1.9e-06, rounding = 0.39;
  static constexpr std::array<long double, 5> powers = {
      1.59133668765030163050e-01L, -5.25696393340316875846e-02L, 2.86732422662419263965e-02L,
      -1.35530541466506439316e-02L, 3.31760294984577007607e-03L};
};
template <> struct ArcTangent<9> {
  static constexpr double worst = 9.2e-10, rounding = 0.51;
  static constexpr std::array<long double, 9> powers = {
      1.59154925009197835217e-01L, -5.30504758321733482726e-02L, 3.18085585584301322862e-02L,
      -2.25382963940221289958e-02L, 1.67095921167465727360e-02L, -1.15146340373103178759e-02L,
      6.33137937834361915656e-03L, -2.29204788319265519656e-03L, 3.91000000114572861251e-04L};
};
template <> struct ArcTangent<12> {
  static constexpr double worst = 3.6e-12, rounding = 0.66;
  static constexpr std::array<long double, 12> powers = {
      1.59154943001212250040e-01L, -5.30516376822860188941e-02L, 3.18306600268436676497e-02L,
      -2.27313865357366841286e-02L, 1.76402104266696656606e-02L, -1.42302319434644292481e-02L,
      1.13685563433024171057e-02L, -8.35795131889721216500e-03L, 5.12997230800177062496e-03L,
      -2.34295431822797621539e-03L, 6.83355038520262664357e-04L, -9.35353494583723250902e-05L};
};
template <> struct ArcTangent<18> {
  static constexpr double worst = 6.1e-17, rounding = 0.88;
  static constexpr std::array<long double, 18> powers = {
      1.59154943091893040201e-01L, -5.30516476967527377681e-02L, 3.18309885796486625221e-02L,
      -2.27364191454337059954e-02L, 1.76838576274716360734e-02L, -1.44683232950040889978e-02L,
      1.22400733168744669852e-02L, -1.05943236075337837192e-02L, 9.28901416301217742575e-03L,
      -8.12182967750613239561e-03L, 6.88627974561157317588e-03L, -5.42718546724503733308e-03L,
      3.77162087958585227105e-03L, -2.18082002044332480193e-03L, 9.84176724785899621727e-04L,
      -3.19921616699032095928e-04L, 6.59474069190832773233e-05L, -6.43100918460923368147e-06L};
};

/// acos(y) / (pi sqrt(1 - y^2)) by powers of y, for y from 0 to 1. `worst` is in half turns
/// of the angle.
template <int Terms>
struct ArcCosine;
template <> struct ArcCosine<4> {
  static constexpr double worst = 1.9e-04, rounding = 2;
  static constexpr std::array<long double, 4> powers = {
      4.99812223324232442027e-01L, -3.10137353871440090444e-01L, 1.92736303871740093238e-01L,
      -6.52637771651731069864e-02L};
};
template <> struct ArcCosine<6> {
  static constexpr double worst = 4.7e-06, rounding = 2;
  static constexpr std::array<long double, 6> powers = {
      4.99995356903667637988e-01L, -3.17896053344311351369e-01L, 2.43964816601759012279e-01L,
      -1.78799861742318460549e-01L, 9.58704540352802761879e-02L, -2.48666599311323792668e-02L};
};
template <> struct ArcCosine<11> {
  static constexpr double worst = 5.3e-10, rounding = 2;
  static constexpr std::array<long double, 11> powers = {
      4.99999999476076221669e-01L, -3.18309743041851005163e-01L, 2.49993524408952327978e-01L,
      -2.12091659990190721741e-01L, 1.86441601418733150691e-01L, -1.63961904147534530900e-01L,
      1.35709024770660412518e-01L, -9.59247186812706185567e-02L, 5.10998878655357096212e-02L,
      -1.74191691650267864147e-02L, 2.77305168961700153385e-03L};
};
template <> struct ArcCosine<15> {
  static constexpr double worst = 4.0e-13, rounding = 2;
  static constexpr std::array<long double, 15> powers = {
      4.99999999999607676402e-01L, -3.18309885990570344457e-01L, 2.49999984198732320970e-01L,
      -2.12206079624793151500e-01L, 1.87491303722884183934e-01L, -1.69675566653268585762e-01L,
      1.55639671017834998299e-01L, -1.42620307185073599224e-01L, 1.26794961624881286121e-01L,
      -1.03975433768475734856e-01L, 7.34523380630297837373e-02L, -4.13000538311865827419e-02L,
      1.68338170110369972612e-02L, -4.34029676347732188347e-03L, 5.25434371151637091169e-04L};
};
template <> struct ArcCosine<21> {
  static constexpr double worst = 8.6e-18, rounding = 2.4;
  static constexpr std::array<long double, 21> powers = {
      4.99999999999999991435e-01L, -3.18309886183782659555e-01L, 2.49999999998745066180e-01L,
      -2.12206590711043689037e-01L, 1.87499997418746428002e-01L, -1.69765220318623975189e-01L,
      1.56249290052594207691e-01L, -1.45506255827050971118e-01L, 1.36670142705866259981e-01L,
      -1.29081974269293540090e-01L, 1.21939787807045733062e-01L, -1.13896494586240389607e-01L,
      1.02914099309052050925e-01L, -8.70158858795691343536e-02L, 6.60463749965079908015e-02L,
      -4.29969838150326250105e-02L, 2.28737049769461183744e-02L, -9.40837017719229072631e-03L,
      2.77861953336311721521e-03L, -5.20785197411232237081e-04L, 4.63163501644726546179e-05L};
};

/// log2(1 - w) / w by powers of w, for w from 0 to 1/2. `worst` is relative.
template <int Terms>
struct Logarithm;
template <> struct Logarithm<3> {
  static constexpr double worst = 2.3e-03, rounding = 1.5;
  static constexpr std::array<long double, 3> powers = {
      -1.44601151911769247474e+00L, -6.11017258264554814751e-01L, -9.75528946731064515669e-01L};
};
template <> struct Logarithm<6> {
  static constexpr double worst = 6.5e-06, rounding = 1.8;
  static constexpr std::array<long double, 6> powers = {
      -1.44268567605472607606e+00L, -7.22639378922110142505e-01L, -4.52531745580039758685e-01L,
      -5.81929498341148426473e-01L, 4.48813556036748649699e-01L, -1.22106802022291569443e+00L};
};

/// (2^y - 1) / y by powers of y, for y from -1 to 0. `worst` is that of (2^y)^16,
/// where the result is at most 1.
template <int Terms>
struct Exponential;
template <> struct Exponential<2> {
  static constexpr double worst = 2.2e-04, rounding = 8.5;
  static constexpr std::array<long double, 2> powers = {
      6.92027230479235410396e-01L, 2.21797522460778447087e-01L};
};
template <> struct Exponential<3> {
  static constexpr double worst = 6.1e-06, rounding = 8.8;
  static constexpr std::array<long double, 3> powers = {
      6.93105951557001032559e-01L, 2.39205832696528265612e-01L, 4.94782325466040235197e-02L};
};

/// 255 (1.055 r^(5/6) - 0.055) by powers of r, for r from the root of 0.0031308 to 1.
/// `worst` is in levels of a byte.
template <int Terms>
struct SrgbCurve;
template <> struct SrgbCurve<3> {
  static constexpr double worst = 1.5e+00, rounding = 400;
  static constexpr std::array<long double, 3> powers = {
      -5.64252662479459411379e+00L, 3.13684710474579444173e+02L, -5.44661819058283149589e+01L};
};
template <> struct SrgbCurve<4> {
  static constexpr double worst = 4.9e-01, rounding = 740;
  static constexpr std::array<long double, 4> powers = {
      -8.15110580727890378632e+00L, 3.46163835513180147274e+02L, -1.37860181453614567465e+02L,
      5.53287955688095427313e+01L};
};

}  // namespace texmap::fits
// clang-format on
