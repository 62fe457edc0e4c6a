/* SPH-TM: the shapes that dump image draws for a fix, one row of numbers each. Their numbers have changed, and in newer
   versions a triangle needs no setting of the dump. */
#ifndef SPHTM_DUMP_SHAPES_H
#define SPHTM_DUMP_SHAPES_H

#if __has_include("graphics.h")
#include "graphics.h"
#endif

namespace SPHTM_NS {

struct DumpShapes {
#if __has_include("graphics.h")
  static constexpr int LINE = LAMMPS_NS::Graphics::LINE, TRIANGLE = LAMMPS_NS::Graphics::TRIANGLE;
#else
  static constexpr int LINE = 1, TRIANGLE = 2;
#endif
  static constexpr int COLUMNS = 10;    // atom type for the color, then two or three corners
};

}    // namespace SPHTM_NS

#endif
