/* SPH-TM: when a particle is split or merged: per-atom values, their gradients, neighbor counts and regions,
   joined with and/or ('and' binds closer). See doc/fix_adapt_neigh.rst. */
#ifndef SPHTM_REFINE_CRITERION_H
#define SPHTM_REFINE_CRITERION_H

#include "cloud.h"

#include <string>
#include <vector>

namespace SPHTM_NS {

class Keywords;

class RefineCriteria {
 public:
  // name: a word for the IDs of the computes that it makes
  RefineCriteria(AdaptParts &all, const std::string &name) : parts(all), label(name) {}
  ~RefineCriteria();
  // reads 'criterion [and|or criterion] ...'
  void read(const std::string &what, Keywords &);
  bool empty() const { return terms.empty(); }
  void init(int every);    // checks that what the terms name is there, every so many steps
  // whether the criteria hold, for every particle of this rank; at the end of a step
  std::vector<char> hold(Cloud &);

 private:
  enum Kind { VALUE, GRADIENT, NEIGHBORS, REGION };
  struct Source {    // of per-atom values
    enum { OWN, COMPUTE, FIX, VARIABLE } kind = OWN;
    std::string name;          // ID or attribute
    int column = 0;            // of an array, from 1; 0: a vector
    std::string compute_id;    // OWN: the compute that was made for it
    std::vector<double> values;
  };
  struct Term {
    Kind kind = VALUE;
    bool negate = false, above = true, after_or = false;
    double limit = 0.0;
    int source = -1;
    std::string region;
  };
  AdaptParts &parts;
  std::string label;
  std::vector<Source> sources;
  std::vector<Term> terms;

  Term read_term(const std::string &what, Keywords &);
  int read_source(const std::string &what, const std::string &text);
  void take_values(Source &);
  std::vector<char> test(const Term &, Cloud &);
};

}    // namespace SPHTM_NS

#endif
