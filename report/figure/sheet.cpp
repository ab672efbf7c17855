#include "report/figure/sheet.hpp"

#include "report/drawing/text_fit.hpp"
#include "report/figure/style.hpp"
#include "report/number_label.hpp"
#include "report/separation_words.hpp"
#include "report/xml_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

namespace beespace::report {
namespace {

constexpr double kRowHeight = 20.0;

void add_text(Spot at, const std::string& text, double size, Ink ink, Drawing& drawing,
              Anchor anchor = Anchor::kStart, bool bold = false) {
  drawing.shapes.emplace_back(Text{at, text, size, anchor, bold, false, false, ink});
}

void add_shades(Spot left, Drawing& drawing) {
  double x = left.x;
  for (const Ink& ink : shades()) {
    drawing.shapes.emplace_back(Area{
        {{x, left.y - 5.0}, {x + 4.0, left.y - 5.0}, {x + 4.0, left.y + 5.0}, {x, left.y + 5.0}},
        ink});
    x += 4.0;
  }
}

// Returns how wide the sample is.
double draw_sample(KeyEntry::Sample sample, Spot left, Drawing& drawing) {
  const Spot right{left.x + 24.0, left.y};
  const Spot middle{left.x + 12.0, left.y};
  switch (sample) {
    case KeyEntry::Sample::kBee:
      drawing.shapes.emplace_back(Dots{{{left.x + 4.0, left.y}}, 3.0, kBee});
      return 10.0;
    case KeyEntry::Sample::kAtRisk:
      drawing.shapes.emplace_back(Diamonds{{{{left.x + 6.0, left.y}, 6.0}}, kRisk});
      return 14.0;
    case KeyEntry::Sample::kPair:
      drawing.shapes.emplace_back(Lines{{{left, right}}, kRisk, 1.2});
      drawing.shapes.emplace_back(Diamonds{{{left, 5.0}, {right, 5.0}}, kRisk});
      return 31.0;
    case KeyEntry::Sample::kShades:
      add_shades(left, drawing);
      return 4.0 * static_cast<double>(shades().size()) + 2.0;
    case KeyEntry::Sample::kBinned:
      drawing.shapes.emplace_back(
          Diamonds{{{{left.x + 3.0, left.y}, 3.0}, {{left.x + 14.0, left.y}, 6.0}}, kRisk});
      return 22.0;
    case KeyEntry::Sample::kPath:
      drawing.shapes.emplace_back(Lines{{{left, right}}, kPath, 1.2});
      return 26.0;
    case KeyEntry::Sample::kInConflict:
      drawing.shapes.emplace_back(Lines{{{left, right}}, kRisk, 2.4});
      drawing.shapes.emplace_back(Diamonds{{{middle, 5.0}}, kRisk});
      return 26.0;
    case KeyEntry::Sample::kAhead:
      drawing.shapes.emplace_back(Lines{{{left, right}}, kRisk, 1.4, true});
      drawing.shapes.emplace_back(Dots{{right}, 4.0, kRisk, 1.4});
      return 30.0;
    case KeyEntry::Sample::kStart:
      drawing.shapes.emplace_back(Dots{{{left.x + 4.0, left.y}}, 3.0, kBee, 1.2});
      return 10.0;
    case KeyEntry::Sample::kBand:
      drawing.shapes.emplace_back(Area{{{left.x, left.y - 6.0},
                                        {left.x + 14.0, left.y - 6.0},
                                        {left.x + 14.0, left.y + 6.0},
                                        {left.x, left.y + 6.0}},
                                       kRiskBand});
      return 16.0;
    case KeyEntry::Sample::kUnknown:
      drawing.shapes.emplace_back(hatching({left.x, left.y - 6.0, 16.0, 12.0}));
      return 18.0;
  }
  return 0.0;
}

// Returns where it ends.
double draw_key(const std::vector<KeyEntry>& key, Spot corner, double size, Drawing& drawing) {
  const double between = size == kTextSize ? 22.0 : 14.0;
  double x = corner.x - between;
  for (const KeyEntry& entry : key) {
    x += between;
    x += draw_sample(entry.sample, {x, corner.y - 4.0}, drawing) + 5.0;
    add_text({x, corner.y}, entry.text, size, kText, drawing);
    x += text_width(entry.text, size);
  }
  return x;
}

// Smaller where it would leave the sheet.
void draw_key(const std::vector<KeyEntry>& key, Spot corner, Drawing& drawing) {
  constexpr double kSmallest = 10.0;
  double size = kTextSize;
  Drawing tried;
  while (size > kSmallest && draw_key(key, corner, size, tried) > kRight) size -= 1.0;
  draw_key(key, corner, size, drawing);
}

std::string degrees(double value, const char* positive, const char* negative) {
  return decimal_label(std::abs(value), 5) + "\u00b0 " + (value < 0.0 ? negative : positive);
}

std::string as_sentence(std::string note) {
  if (note.empty()) return note;
  const auto is_letter = [&note](std::size_t i) {
    return i < note.size() && note[i] >= 'a' && note[i] <= 'z';
  };
  char& first = note.front();
  if (is_letter(0) && is_letter(1)) first = static_cast<char>(first - 'a' + 'A');
  if (note.back() != '.') note += '.';
  return note;
}

// In one line, or in two or three smaller ones, so that who is unknown is not cut off.
void add_findings(const std::string& findings, double width, Drawing& drawing) {
  constexpr double kSize = 15.0;
  constexpr double kMiddle = 76.0;
  constexpr std::size_t kMostLines = 3;
  constexpr const char* kMore = " \u2026";
  if (text_width(findings, kSize) <= width) {
    return add_text({kMargin, kMiddle}, findings, kSize, kText, drawing);
  }
  std::vector<std::string> lines = wrapped(findings, kTextSize, width);
  if (lines.size() > kMostLines) {
    lines.resize(kMostLines);
    // Between words: the rest is in the notes.
    std::string& last = lines.back();
    while (text_width(last + kMore, kTextSize) > width) {
      const auto blank = last.find_last_of(' ');
      if (blank == std::string::npos) break;
      last.resize(blank);
    }
    last += kMore;
  }
  // Three have little room between the title and the key.
  const double apart = lines.size() < kMostLines ? 16.0 : 13.0;
  double y = lines.size() < kMostLines ? kMiddle - 5.0 : kMiddle - 11.0;
  for (const std::string& line : lines) {
    add_text({kMargin, y}, fitted(line, kTextSize, width), kTextSize, kText, drawing);
    y += apart;
  }
}

// Whether a note says which columns, or units, were taken.
bool is_of_reading(const std::string& note) {
  return note.find(" read from ") != std::string::npos ||
         note.find("the header ") != std::string::npos;
}

std::string origin_note(const GeographicPosition& origin, const HeightWords& heights, bool flat) {
  const std::string_view counted = heights.by_pressure ? "by pressure"
                                   : heights.above_sea ? "above mean sea level"
                                   : heights.unstated
                                       ? "those of the input, taken as above the ellipsoid"
                                       : "above the ellipsoid";
  return "East and north are counted along the ground from " +
         degrees(origin.latitude_deg, "N", "S") + ", " + degrees(origin.longitude_deg, "E", "W") +
         (flat ? "." : "; heights are " + std::string(counted) + ".");
}

constexpr double kBesideName = 12.0;
constexpr double kAboveRows = 6.0 + kRowHeight;
constexpr double kInkApart = 9.0;  // from one dot to the next

// How far names begin behind the dots that say whose path they are of.
double indent_of(const Row& row) {
  return row.inks.empty() ? 0.0 : 3.0 + kInkApart * static_cast<double>(row.inks.size());
}

// Whether what is said of a row goes below its name, where that would be cut.
bool is_said_below(const Listing& listing, double width) {
  return std::any_of(listing.rows.begin(), listing.rows.end(), [&](const Row& row) {
    return text_width(one_line(row.left), kLabelSize) + text_width(row.right, kLabelSize) +
               kBesideName + indent_of(row) >
           width;
  });
}

// A row as it is drawn: names, and what is said of them below, each in as many lines as it takes.
struct RowLines {
  std::vector<std::string> names;
  std::vector<std::string> said;
};

RowLines lines_of(const Row& row, double width) {
  const auto broken = [](const std::string& text, double room) {
    constexpr std::size_t kMost = 2;
    std::vector<std::string> lines = wrapped(text, kLabelSize, room);
    for (std::size_t i = kMost; i < lines.size(); ++i)
      lines[kMost - 1].append(" ").append(lines[i]);
    lines.resize(std::min(lines.size(), kMost));
    if (!lines.empty()) lines.back() = fitted(lines.back(), kLabelSize, room);
    return lines;
  };
  const double room = width - indent_of(row);
  const auto fits = [room](const std::string& text) {
    return text_width(text, kLabelSize) <= room;
  };
  const std::string left = one_line(row.left);
  RowLines lines{broken(left, room), {}};
  // Two names stand below each other rather than that one of them is broken.
  constexpr std::string_view kBetween = " \u2013 ";
  const std::size_t between = left.find(kBetween);
  if (lines.names.size() > 1 && between != std::string::npos) {
    std::string first = left.substr(0, between) + " \u2013";
    std::string second = left.substr(between + kBetween.size());
    if (fits(first) && fits(second)) lines.names = {std::move(first), std::move(second)};
  }
  // What is said of all conflicts of two stands below what is said of the closest.
  const std::size_t all = row.right.find("; ");
  if (all == std::string::npos || text_width(row.right, kLabelSize) <= width) {
    lines.said = broken(row.right, width);
  } else {
    lines.said = {fitted(row.right.substr(0, all + 1), kLabelSize, width),
                  fitted(row.right.substr(all + 2), kLabelSize, width)};
  }
  return lines;
}

// All rows are as high as the highest.
double row_height(const Listing& listing, double width) {
  constexpr double kBetweenRows = 0.3 * kRowHeight;
  if (!is_said_below(listing, width)) return kRowHeight;
  std::size_t most = 2;
  for (const Row& row : listing.rows) {
    const RowLines lines = lines_of(row, width);
    most = std::max(most, lines.names.size() + lines.said.size());
  }
  return kBetweenRows + 0.8 * kRowHeight * static_cast<double>(most);
}

}  // namespace

std::vector<Ink> shades() {
  return {{0xdfe7ef}, {0xc9d6e3}, {0xb1c4d6}, {0x98b0c7},
          {0x7f9bb7}, {0x6686a5}, {0x4d7091}, {0x355a7b}};
}

std::string too_close(const SwarmFacts& swarm) {
  const auto within = [&swarm](const std::string& words) {
    return swarm.inclusive ? words + " or closer" : "closer than " + words;
  };
  if (!swarm.vertical_m) return within(distance_words(swarm, swarm.threshold_m));
  return within(distance_words(swarm, swarm.threshold_m)) + " across and " +
         within(height_words(swarm, *swarm.vertical_m)) + " in height";
}

std::string threshold_name(const SwarmFacts& swarm) {
  return (swarm.vertical_m ? "horizontally " : "threshold ") +
         distance_words(swarm, swarm.threshold_m);
}

Drawing begin_sheet(const SwarmFacts& swarm, const std::string& findings,
                    const std::vector<KeyEntry>& key) {
  const std::string title = one_line(swarm.title);
  Drawing drawing{kFigureWidth, 0.0, title, findings, {}};
  const double width = kRight - kMargin;
  drawing.shapes.emplace_back(Text{{kMargin, 50.0},
                                   fitted(title, kTitleSize, width),
                                   kTitleSize,
                                   Anchor::kStart,
                                   true,
                                   false,
                                   false,
                                   kText});
  add_findings(findings, width, drawing);
  draw_key(key, {kMargin, 106.0}, drawing);
  return drawing;
}

double listing_height(const Listing& listing, double width, std::size_t most) {
  if (listing.rows.empty()) return 0.0;
  const std::size_t rows = std::min(most, listing.rows.size());
  return kAboveRows + static_cast<double>(rows) * row_height(listing, width);
}

void draw_listing(const Listing& listing, Spot corner, double width, double bottom,
                  Drawing& drawing) {
  if (listing.rows.empty()) return;
  const bool below = is_said_below(listing, width);
  const double height = row_height(listing, width);
  const double first = corner.y + kAboveRows;
  const double room = std::max(0.0, std::floor((bottom - first) / height) + 1.0);
  const std::size_t shown = std::min(listing.rows.size(), static_cast<std::size_t>(room));
  std::string heading = listing.heading;
  if (shown < listing.count)
    heading += ": " + count_label(shown) + " of " + count_label(listing.count);
  add_text(corner, heading, kTextSize, kText, drawing, Anchor::kStart, true);
  for (std::size_t i = 0; i < shown; ++i) {
    const Row& row = listing.rows[i];
    const double y = first + static_cast<double>(i) * height;
    const double indent = indent_of(row);
    for (std::size_t ink = 0; ink < row.inks.size(); ++ink) {
      const Spot dot{corner.x + 3.0 + kInkApart * static_cast<double>(ink), y - 4.0};
      drawing.shapes.emplace_back(Dots{{dot}, 3.2, row.inks[ink]});
    }
    if (!below) {
      const double beside = width - indent - text_width(row.right, kLabelSize) - kBesideName;
      add_text({corner.x + indent, y}, fitted(one_line(row.left), kLabelSize, beside), kLabelSize,
               kText, drawing);
      add_text({corner.x + width, y}, row.right, kLabelSize, kText, drawing, Anchor::kEnd);
      continue;
    }
    const RowLines lines = lines_of(row, width);
    double line_y = y;
    for (const std::string& line : lines.names) {
      add_text({corner.x + indent, line_y}, line, kLabelSize, kText, drawing);
      line_y += 0.8 * kRowHeight;
    }
    for (const std::string& line : lines.said) {
      add_text({corner.x + width, line_y}, line, kLabelSize, kQuietText, drawing, Anchor::kEnd);
      line_y += 0.8 * kRowHeight;
    }
  }
}

void finish_sheet(const SwarmFacts& swarm, double bottom, Drawing& drawing) {
  constexpr std::size_t kMostLines = 8;
  std::vector<std::string> lines;
  const auto say = [&lines](const std::string& note) {
    const auto more = wrapped(as_sentence(one_line(note)), kLabelSize, kRight - kMargin);
    lines.insert(lines.end(), more.begin(), more.end());
  };
  if (swarm.origin) say(origin_note(*swarm.origin, swarm.heights, swarm.flat));
  // What is wrong, or unknown, comes before how columns were read.
  std::vector<std::string> notes = swarm.notes;
  std::stable_partition(notes.begin(), notes.end(),
                        [](const std::string& note) { return !is_of_reading(note); });
  for (const std::string& note : notes) say(note);
  if (lines.size() > kMostLines) {
    lines.resize(kMostLines);
    lines.back() = "\u2026 and more";
  }
  double y = bottom + 10.0;
  for (const std::string& line : lines) {
    y += 17.0;
    add_text({kMargin, y}, line, kLabelSize, kQuietText, drawing);
  }
  drawing.height = y + 30.0;
}

}  // namespace beespace::report
