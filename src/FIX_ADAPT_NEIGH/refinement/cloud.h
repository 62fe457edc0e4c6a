/* SPH-TM: particles of this rank and their ghosts as one table at the end of a step, for what looks at
   neighborhoods now and then: criteria, interpolation, families. On the host. Ghosts get their rows by one
   forward communication, positions included: those that LAMMPS keeps are of half a step ago. */
#ifndef SPHTM_CLOUD_H
#define SPHTM_CLOUD_H

#include "adapt_parts.h"
#include "tm_fields.h"
#include "tm_rates.h"
#include "tm_refine.h"

#include <vector>

namespace SPHTM_NS {

class Cloud {
 public:
  explicit Cloud(AdaptParts &all) : parts(all) {}
  // for the buffers of the communication
  static constexpr int MOST_COLUMNS = (int) TM_CLOUD_STATE + (int) TM_FIELDS_COLUMNS;
  // the owned particles, with the columns of all state fields, or with values as the only one
  void take_state();
  void take_values(const std::vector<double> &values);
  void forward();    // to the ghosts, on all ranks

  double *row(int i) { return rows.data() + (size_t) i * table.width; }
  const tm_cloud &view() const { return table; }
  int column(int field) const { return at[field]; }    // first column of a state field, or -1
  double size(int i) const;                            // smoothing length of owned particle i
  // mechanical neighbors of owned particle i, skin included; valid until the next call
  const std::vector<int> &neighbors(int i);
  int count_within_support(int i);

 private:
  AdaptParts &parts;
  tm_cloud table = {};
  tm_rows links = {};
  std::vector<double> rows;
  std::vector<int> near;
  int at[TM_F_COUNT];

  void begin(int columns);
};

}    // namespace SPHTM_NS

#endif
