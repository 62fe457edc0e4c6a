/* SPH-TM: a compute whose values per particle are where the loops run, so that they can be summed up there. */
#ifndef SPHTM_VALUES_OF_LOOPS_H
#define SPHTM_VALUES_OF_LOOPS_H

namespace SPHTM_NS {

class ValuesOfLoops {
 public:
  // of now: rows of so many columns, a row for each particle of this rank; nullptr: ask for those on the host
  virtual const double *values_of_loops(int &columns) = 0;

 protected:
  ~ValuesOfLoops() = default;
};

}    // namespace SPHTM_NS

#endif
