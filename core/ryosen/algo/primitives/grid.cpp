#include "ryosen/algo/primitives/grid.h"

#include "ryosen/algo/primitives/shape.h"

namespace ryosen {

namespace {

// From -extent / 2 to extent / 2, both exactly.
double line_at(std::size_t i, std::size_t count, double extent) {
  const auto twice = 2 * static_cast<double>(i), all = static_cast<double>(count);
  return extent / 2 * ((twice - all) / all);
}

}  // namespace

AlgorithmResult add_grid(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const ParameterValues& values = input.values;
  const std::size_t columns = values.count("columns"), rows = values.count("rows");
  Shape shape(values.place("at"));
  for (std::size_t row = 0; row <= rows; ++row)
    for (std::size_t column = 0; column <= columns; ++column)
      shape.add_point(
          {line_at(column, columns, values.length("width")), 0, line_at(row, rows, values.length("depth"))});
  const auto line = static_cast<std::uint32_t>(columns + 1);
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t corner = row * line + column;
      shape.add_face({corner, corner + line, corner + line + 1, corner + 1});
    }
  return std::move(shape).add_to(edit, progress);
}

}  // namespace ryosen
