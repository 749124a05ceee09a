// The mistakes that have a card in docs/symptoms.md.
#pragma once

namespace texmap::slips {

/// What a mistake's words hold, and its card: the name of the card's picture.
struct Card {
  const char *words, *name;
};
inline constexpr Card cards[] = {
    {"mirrored: u runs", "mirrored"},
    {"upside down: v runs", "upside_down"},
    {"turned by half: u and v", "half_turn"},
    {"a quarter turn off", "quarter_turn"},
    {"striped", "stripes"},
    {"half a texel", "half_a_texel"},
    {"squeezed at the poles", "squeezed_pole"},
    {"black texture", "black"},
    {"too dark: light was", "too_dark"},
    {"the texture is too dark", "too_dark"},
    {"too pale", "too_pale"},
    {"dark at the outline", "dark_rim"},
    {"blurred far away", "blurred"},
    {"shining on its night side", "night_highlight"},
    {"dents and not bumps", "dents"},
    {"mixed evenly in the picture", "bent"},
};

}  // namespace texmap::slips
