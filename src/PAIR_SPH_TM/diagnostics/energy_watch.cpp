#include "energy_watch.h"

#include "fmt/format.h"

#include <algorithm>
#include <cmath>

namespace SPHTM_NS {

void EnergyWatch::begin(const Energies &e, double least_)
{
  least = least_;
  base += begun ? e.sum - last_sum : e.sum;
  base_unstored += begun ? e.unstored - last_unstored : e.unstored;
  // also what is stored where bodies overlap from the start
  given += begun ? std::max({e.sum - last_sum, e.kinetic - last_kinetic, 0.0}) : std::max(e.sum, e.kinetic);
  begun = true;
  look(e);
}

void EnergyWatch::look(const Energies &e)
{
  most_work = std::max(most_work, e.external);
  into = given + most_work;
  drifted = e.sum - base;
  made = e.artificial - e.shock;
  shocked = e.shock;
  left = e.left;
  last_kinetic = e.kinetic;
  last_sum = e.sum;
  last_unstored = e.unstored;
}

void EnergyWatch::count(bool last)
{
  auto more = [&](int &looks, bool over) { looks = !over ? 0 : last ? LASTING : looks + 1; };
  more(drifting, says() && std::fabs(drift()) > DRIFT_WARNED);
  more(making, says() && std::fabs(artificial()) > (last ? ARTIFICIAL_WARNED : ARTIFICIAL_SAID_AT_ONCE));
  astray = last && says() && std::fabs(unexplained(last_unstored)) > UNEXPLAINED_WARNED * into;
  if (last && said_at > 0.0 && into > 10.0 * said_at)
    said_artificial = false;    // what was said then was of a first touch
}

bool EnergyWatch::stops(double drift_allowed)
{
  beyond = says() && std::fabs(drift()) > drift_allowed ? beyond + 1 : 0;
  return beyond >= STOPPING || (beyond && drifting == LASTING);
}

std::string EnergyWatch::in_words() const
{
  const std::string gone = left != 0.0 ? fmt::format(", {:.3g} % left with particles", 100.0 * left / into) : "";
  const std::string in_shocks =
      shocked != 0.0 ? fmt::format(", the bulk viscosity of shocks {:+.3g} %", 100.0 * shocked / into) : "";
  return fmt::format(
      "{:.6g} went in{}; the sum drifted by {:+.3g} % of it, artificial terms took {:+.3g} %{}; {:+.3g} % is "
      "work of the stress that is neither stored nor dissipated",
      into, gone, 100.0 * drift(), 100.0 * artificial(), in_shocks,
      into > 0.0 ? 100.0 * unexplained(last_unstored) / into : 0.0);
}

std::string EnergyWatch::warning()
{
  if (!said_drift && drifting >= LASTING) {
    said_drift = true;
    return fmt::format("the sum of the energies has drifted by {:+.3g} % of the {:.6g} that went in", 100.0 * drift(),
                       into);
  }
  if (!said_artificial && making >= LASTING) {
    said_artificial = true;
    said_at = into;
    return fmt::format("artificial terms (viscosity, artificial stress, hourglass resistance) have "
                       "{} {:.3g} % of the {:.6g} "
                       "that went in{}",
                       artificial() > 0.0 ? "taken" : "added", 100.0 * std::fabs(artificial()), into,
                       artificial() > 0.0 ? "; by itself no error of forces, see energy on the page of fix sph/tm"
                                          : "");
  }
  if (!said_astray && astray) {
    said_astray = true;
    return fmt::format(
        "{:+.3g} % of the {:.6g} that went in is work of the stress that is neither stored nor dissipated, "
        "an error of the integration in time that the sum may hide: compare with half the courant",
        100.0 * unexplained(last_unstored) / into, into);
  }
  return "";
}

// 2 more in the place of said_artificial: said_astray
std::vector<double> EnergyWatch::state() const
{
  return {(double) begun,
          base,
          given,
          most_work,
          last_kinetic,
          last_sum,
          (double) said_drift,
          said_artificial + 2.0 * said_astray,
          base_unstored,
          last_unstored};
}

void EnergyWatch::restore(const double *v)
{
  begun = v[0] != 0.0;
  base = v[1];
  given = v[2];
  most_work = v[3];
  last_kinetic = v[4];
  last_sum = v[5];
  said_drift = v[6] != 0.0;
  said_artificial = v[7] == 1.0 || v[7] == 3.0;
  said_astray = v[7] >= 2.0;
  base_unstored = v[8];
  last_unstored = v[9];
}

}    // namespace SPHTM_NS
