#include "refine_input.h"

#include "argument.h"

#include "domain.h"
#include "error.h"
#include "lammps.h"

using namespace LAMMPS_NS;

namespace SPHTM_NS {

bool RefineInput::keyword(Keywords &k)
{
  if (k.is("refine")) read_refine(k);
  else if (k.is("coarsen")) {
    coarsen = k.second("fallen", "when") ? WHEN : FALLEN;
    if (coarsen == WHEN) coarsen_when.read(k.what("when"), k);
  } else return false;
  return true;
}

// refine <pattern> epsilon E alpha A when <criteria> [level N] [every M] [velocity parent|linear] [settle N]
void RefineInput::read_refine(Keywords &k)
{
  Error *error = parts.host()->error;
  if (kind >= 0) error->all(FLERR, "{} is given twice; join criteria with and, or", k.what());
  read_pattern(k);
  while (k.option(options())) {
    if (k.is("epsilon")) read_epsilon(k);
    else if (k.is("alpha")) alpha = k.within(0.0, 1.0);
    else if (k.is("level")) most_level = k.integer(1, 8);
    else if (k.is("every")) every = k.integer(1, 1000000000);
    else if (k.is("settle")) sweeps = k.integer(0, 100);
    else if (k.is("velocity")) linear = k.second("parent", "linear");
    else {
      if (!when.empty()) error->all(FLERR, "{} is given twice; join criteria with and, or", k.what());
      when.read(k.what(), k);
    }
  }
}

void RefineInput::read_epsilon(Keywords &k)
{
  epsilon = k.positive();
  if (epsilon <= 1.0) return;
  parts.host()->error->all(FLERR,
                           "{} must be above 0 and at most 1, got {}: it is how far children are from the "
                           "particle that is split, in its smoothing lengths; beyond 1 they are among its "
                           "neighbors; 0.35 to 0.5 is usual",
                           k.what(), k.given());
}

void RefineInput::read_pattern(Keywords &k)
{
  Error *error = parts.host()->error;
  std::string known;
  for (int n = 0; n < TM_SPLIT_KINDS; n++) known += std::string(n ? ", " : "") + tm_split_name(n);
  if (!k.rest()) error->all(FLERR, "{} needs a pattern: {}", k.what(), known);
  for (int n = 0; n < TM_SPLIT_KINDS && kind < 0; n++)
    if (k.take(tm_split_name(n))) kind = n;
  if (kind < 0) error->all(FLERR, "{}: unknown pattern {}; known are {}", k.what(), k.value(), known);
  const int dim = parts.host()->domain->dimension;
  if (tm_split_dim(kind) != dim)
    error->all(FLERR, "{} {}: the pattern has {} dimensions, the run {}", k.what(), tm_split_name(kind),
               tm_split_dim(kind), dim);
}

void RefineInput::make_pattern(int kernel)
{
  const int status = tm_split_make(kind, kernel, epsilon, alpha, &pattern);
  if (status == TM_SPLIT_OK) return;
  std::string masses;
  for (int k = 0; k < pattern.n; k++) masses += fmt::format(" {:.4g}", pattern.mass[k]);
  const bool none = pattern.mass[0] > 0.5;    // all in the center
  Error *error = parts.host()->error;
  error->all(FLERR, "Fix adapt/neigh refine {} epsilon {:.6g} alpha {:.6g} with the {} kernel {}; take {}",
             tm_split_name(kind), epsilon, alpha, kernel_name(kernel),
             status == TM_SPLIT_SINGULAR
                 ? "puts the children so close together that their masses are not determined"
                 : fmt::format("would give {} of the children {} mass, in parts of the whole:{}",
                               none ? "all but one" : "one", none ? "no" : "a negative", masses),
             status == TM_SPLIT_NEGATIVE && none ? "a smaller alpha" : "a larger epsilon");
}

// all keywords are read
void RefineInput::check() const
{
  Error *error = parts.host()->error;
  if (kind < 0) error->all(FLERR, "Fix adapt/neigh coarsen needs the keyword refine: it merges what was split");
  const std::string what = std::string("Fix adapt/neigh refine ") + tm_split_name(kind);
  if (epsilon == 0.0 || alpha == 0.0)
    error->all(FLERR, "{} needs '{} <number>', in smoothing lengths of the particle that is split", what,
               epsilon == 0.0 ? "epsilon" : "alpha");
  if (when.empty()) error->all(FLERR, "{} needs 'when' with a criterion", what);
}

}    // namespace SPHTM_NS
