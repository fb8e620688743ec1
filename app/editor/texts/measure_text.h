// What is said of measurements and of the values of a colour map.
#pragma once

#include "ryosen/analysis/measures.h"
#include "ryosen/scene/highlights/map_values.h"

namespace ryosen {

// Nine significant digits, and the sign of the unit.
std::string value_text(double value, MapUnit unit);
// Numbers that stand side by side: in one notation, with as many digits as tell them apart to a thousandth of their
// range.
std::vector<std::string> numbers_alike(std::span<const double> values);
// "distance 1.5, angle 90°"
Text text_of(const Measurement& found);
// The same as it is shown, with short numbers as in the status line.
Text short_text_of(const Measurement& found);
// "Edge length: 1 to 2, mean 1.5, median 1.4, of 12"
Text text_of(const ColourMap& map, const MapFigures& figures);
// The same as it is shown: the numbers in one notation, as the ends of a legend.
Text short_text_of(const ColourMap& map, const MapFigures& figures);
// The numbers of values of a map, likewise; those of a map of counts that are whole are written so.
std::vector<std::string> numbers_of(const ColourMap& map, std::span<const double> values);
// The values that a legend names, at most so many: evenly from the low end to the high one; of a map of counts whole,
// as far as there are any in the range.
std::vector<double> legend_values(const ColourMap& map, MapRange range, std::size_t most);
// "v1 v5": what was measured, the first few of many.
std::string names_of_measured(const Mesh& mesh, std::span<const Element> elements);
// Of elements as they are now; that one of them is gone, where that is so.
Text measured_text(const Mesh& mesh, std::span<const Element> elements);

}  // namespace ryosen
