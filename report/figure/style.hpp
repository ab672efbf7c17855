// The inks and sizes of figures. Who is at risk differs from the others in shape, size and
// lightness as well as in colour, for eyes and printers that see no colours. Blue and vermilion are
// those of Okabe and Ito, Color universal design, 2008; those of a few paths are of the muted
// scheme of Paul Tol, Colour schemes, 2021, which the colour-blind tell apart, without its rose,
// which would be near vermilion.
#pragma once

#include "report/drawing/drawing.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace beespace::report {

inline constexpr Ink kText{0x1b1f24};
inline constexpr Ink kQuietText{0x57606a};
inline constexpr Ink kAxis{0x8c959f};
inline constexpr Ink kGrid{0xe7eaee};
inline constexpr Ink kBee{0x7f93a8};
inline constexpr Ink kPath{0x6f88a3, 0.55};
inline constexpr Ink kRisk{0xc8500a};
inline constexpr Ink kRiskBand{0xf6d9c4};
inline constexpr Ink kThreshold{0x1b1f24};

inline constexpr std::array<Ink, 8> kFewPathInks = {{{0x332288, 0.9},
                                                     {0x44aa99, 0.9},
                                                     {0x882255, 0.9},
                                                     {0x999933, 0.9},
                                                     {0x88ccee, 1.0},
                                                     {0x117733, 0.9},
                                                     {0xaa4499, 0.9},
                                                     {0xddcc77, 1.0}}};

// A path's own, where there are so few that all differ.
inline std::optional<Ink> own_ink(std::size_t path, std::size_t paths) {
  return paths <= kFewPathInks.size() && path < paths ? std::optional(kFewPathInks[path])
                                                      : std::nullopt;
}

// Light to dark, for cells by how many are in them.
std::vector<Ink> shades();

inline constexpr double kTitleSize = 22.0;
inline constexpr double kTextSize = 13.0;
inline constexpr double kLabelSize = 12.0;

inline constexpr double kFigureWidth = 1200.0;
inline constexpr double kMargin = 40.0;
inline constexpr double kRight = kFigureWidth - kMargin;

}  // namespace beespace::report
