/* SPH-TM: the files of a run as one data set of ParaView (.pvd): each with its time, and files of one time as its parts. The
   list on disk is whole at any moment: it is written beside the old one and put in its place. */
#ifndef SPHTM_PARAVIEW_SERIES_H
#define SPHTM_PARAVIEW_SERIES_H

#include "lmptype.h"

#include <string>
#include <vector>

namespace SPHTM_NS {

class ParaviewSeries {
 public:
  // pattern: the files' name, with one * for the step, ending in .vtp; otherwise: what to call the series where nothing
  // else is in the name
  ParaviewSeries(const std::string &pattern, const std::string &otherwise);
  // an empty text where a file of particles or of a tool can have this name, or what is wrong
  static std::string wrong_name(const std::string &pattern);

  const std::string &path() const { return pvd; }
  // of a part's file: the series' name, the part's, the step
  std::string part_path(const std::string &part, const std::string &step) const;
  // each returns what went wrong, or an empty text
  std::string begin_anew();                     // no files yet
  std::string go_on(LAMMPS_NS::bigint step);    // with what the list on disk has up to this step
  std::string enter(LAMMPS_NS::bigint step, double time, const std::vector<std::string> &files);    // those of a step
  void drop_removed();    // steps whose first file is no more; their other files are removed

 private:
  struct Entry {
    LAMMPS_NS::bigint step;
    double time;
    int part;
    std::string file;    // without folder
  };
  std::string folder, stem, pvd;
  std::vector<Entry> entries;

  std::string write() const;
};

}    // namespace SPHTM_NS

#endif
