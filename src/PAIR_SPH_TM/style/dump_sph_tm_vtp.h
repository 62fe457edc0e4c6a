/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: dump sph/tm/vtp. Particles and tools for ParaView: what dump
   custom selects and computes, as VTK XML files with a list of their times.
------------------------------------------------------------------------- */
#ifndef LMP_DUMP_SPH_TM_VTP_H
#define LMP_DUMP_SPH_TM_VTP_H

#include "dump_custom.h"

#include "paraview_series.h"
#include "vtp_file.h"

#include <memory>
#include <string>
#include <vector>

namespace SPHTM_NS {
class Scene;
}    // namespace SPHTM_NS

namespace LAMMPS_NS {

class DumpSPHTMVtp : public DumpCustom {
 public:
  DumpSPHTMVtp(class LAMMPS *, int, char **);
  ~DumpSPHTMVtp() override;
  void write() override;

 protected:
  void init_style() override;
  int modify_param(int, char **) override;
  void openfile() override;
  void write_header(bigint) override;
  void write_data(int, double *) override;
  void write_footer() override;

 private:
  struct Values {    // an array of the file
    SPHTM_NS::VtpFile::Array array;
    std::vector<int> columns;    // of dump custom's, -1: 0
  };
  const std::shared_ptr<SPHTM_NS::Scene> scene;
  SPHTM_NS::ParaviewSeries series;
  std::vector<std::string> attributes;
  std::vector<Values> values;
  std::unique_ptr<SPHTM_NS::VtpFile> file;    // that is being written
  bigint rows_done = 0;
  bool single = false, tools = true;
  bool begun = false;      // there is a list of files
  bool written = false;    // the last call of write() wrote a file

  std::string what() const;
  int column(const std::string &attribute) const;    // or -1
  std::string column_name(int) const;
  bool find_triple(const char *const of[3], std::vector<int> &columns) const;
  void plan_values();
  void begin_series();
  void check_series(const std::string &wrong);
};

}    // namespace LAMMPS_NS

#endif
