/* SPH-TM: what pair sph/tm and fix sph/tm ask fix adapt/neigh for: rows of neighbors in place of LAMMPS's list, and the
   rule of smoothing lengths. */
#ifndef SPHTM_ROW_SOURCE_H
#define SPHTM_ROW_SOURCE_H

#include "tm_asph.h"
#include "tm_rates.h"

namespace SPHTM_NS {

class RowSource {
 public:
  static constexpr const char *NAME = "sph/tm rows";    // what Fix::extract() knows it by
  virtual ~RowSource() = default;

  // brings the rows to the positions of this step; renumbered: particles have new places in memory
  virtual void renew(bool renumbered) = 0;
  virtual tm_rows mechanical() = 0;
  virtual tm_rows host_mechanical() = 0;
  // the rows that tm_rates() is for, into the arguments; returns how many. The others it leaves to
  virtual int searched(tm_rates_args &) = 0;
  // the correction of gradients, of the particles it leaves; then what they show each other
  virtual void kept_moments(const tm_rates_args &, unsigned /*effects*/) {}
  virtual void show(const tm_records &) {}
  virtual void kept_rates(const tm_rates_args &, unsigned /*effects*/) {}
  virtual bool keeps() const { return false; }    // rows that are not searched in every step
  virtual tm_rows others() = 0;         // neighbors that exchange heat, and those in contact
};

// how smoothing lengths are set, see tm_smoothing.h
struct SmoothingRule {
  static constexpr const char *NAME = "sph/tm smoothing rule";    // what Fix::extract() knows it by
  const tm_asph_table *table = nullptr;                           // on the host; none: h follows the density
  double least = 0.5, most = 2.0;                                 // see tm_smoothing.h
};

}    // namespace SPHTM_NS

#endif
