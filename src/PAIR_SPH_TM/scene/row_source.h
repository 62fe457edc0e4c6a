/* SPH-TM: what pair sph/tm and fix sph/tm ask fix adapt/neigh for: rows of neighbors in place of LAMMPS's list, and the
   rule of smoothing lengths. */
#ifndef SPHTM_ROW_SOURCE_H
#define SPHTM_ROW_SOURCE_H

#include "tm_asph.h"
#include "tm_rates.h"

namespace SPHTM_NS {

class RowSource {
 public:
  virtual ~RowSource() = default;

  // brings the rows to the positions of this step; renumbered: particles have other indices
  virtual void renew(bool renumbered) = 0;
  virtual tm_rows mechanical() = 0;
  virtual tm_rows host_mechanical() = 0;
  // rows and list of the updated-Lagrangian particles into the arguments of tm_rates(); returns their number
  virtual int ul_rows(tm_rates_args &) = 0;
  // of total-Lagrangian particles: corrections of gradients, what they export to others, rates
  virtual void tl_corrections(const tm_rates_args &, unsigned /*effects*/) {}
  virtual void tl_export(const tm_records &) {}
  virtual void tl_rates(const tm_rates_args &, unsigned /*effects*/) {}
  virtual bool has_tl() const { return false; }    // there may be total-Lagrangian pairs
  // pairs are frozen at the start and stay, however far their particles are apart
  virtual bool keeps_all() const { return false; }
  virtual tm_rows others() = 0;    // neighbors that exchange heat, and those in contact
};

// how smoothing lengths are set, see tm_smoothing.h
struct SmoothingRule {
  const tm_asph_table *table = nullptr;    // on the host; none: h follows the density
  double least = 0.5, most = 2.0;          // see tm_smoothing.h
};

}    // namespace SPHTM_NS

#endif
