/* SPH-TM: neighbor lists of LAMMPS that reach further from now on. */
#ifndef SPHTM_NEIGHBOR_CUTOFF_H
#define SPHTM_NEIGHBOR_CUTOFF_H

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

// Takes the cutoffs of the pair style in use (cutsq) as Neighbor::init() does, during a run: for pre_exchange of
// a step that renews the lists. Collective.
void widen_neighbor_lists(LAMMPS_NS::LAMMPS *);

}    // namespace SPHTM_NS

#endif
