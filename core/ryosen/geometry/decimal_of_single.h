// Numbers that are read from text in double precision, and stand there for floats.
#pragma once

namespace ryosen {

// Whether the value is a float, or a decimal that the nearest float gives when it is printed with as many digits. Every
// decimal of up to six digits is one, and so are infinities; a number beyond the range of floats is none.
bool is_decimal_of_single(double value);

}  // namespace ryosen
