/* SPH-TM: rows of neighbors that another style keeps for pair sph/tm, in place of LAMMPS's list. */
#ifndef SPHTM_ROW_SOURCE_H
#define SPHTM_ROW_SOURCE_H

#include "tm_rates.h"

namespace SPHTM_NS {

class RowSource {
 public:
  static constexpr const char *NAME = "sph/tm rows";    // what Fix::extract() knows it by
  virtual ~RowSource() = default;

  // the records of the owned particles are made
  virtual void show(const tm_records &) {}
  // brings the rows to the positions of this step; renumbered: particles have new places in memory
  virtual void renew(bool renumbered) = 0;
  virtual tm_rows mechanical() = 0;
  // the rows that tm_rates() is for, into the arguments; returns how many. The others it leaves to
  virtual int searched(tm_rates_args &) = 0;
  virtual void kept_rates(const tm_rates_args &, unsigned /*effects*/) {}
  virtual tm_rows others() = 0;         // neighbors that exchange heat, and those in contact
  virtual tm_rows host_others() = 0;
};

}    // namespace SPHTM_NS

#endif
