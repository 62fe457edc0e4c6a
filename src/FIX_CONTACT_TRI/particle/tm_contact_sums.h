/* SPH-TM: what the contacts of one tool add up to, in a step, and adding into what several threads share. */
#ifndef TM_CONTACT_SUMS_H
#define TM_CONTACT_SUMS_H

#include "tm_real.h"
#include "tm_tensor.h"

/* Sums over particles, but for the depth; all in mass-length-time units. */
typedef struct {
  tm_vec3 force, torque;  /* on the tool */
  tm_real friction_power; /* dissipated by friction */
  tm_real friction_heat;  /* of it, into the particles */
  tm_real conducted;      /* heat from the tool into the particles besides */
  tm_real heat_tool;      /* into the tool: friction_power - friction_heat - conducted */
  tm_real spring;         /* energy of the contact springs */
  tm_real damping_power;  /* dissipated by damping */
  tm_real particle_power; /* work of contact forces on particles, per time */
  tm_real tool_power;     /* work done by the tool's motion, per time */
  tm_real late_friction;  /* what this tool changes in the friction power of earlier ones */
  tm_real depth;          /* deepest penetration */
  tm_real inner;          /* deepest center behind the surface, 0: none */
  tm_real within;         /* deepest center within half a spacing of the surface, where the layer is thinner */
  int contacts;
  int faced; /* particles that are pressed from two opposite sides: one row, which has no strain across */
} tm_contact_result;

TM_FN tm_contact_result tm_contact_nothing(void)
{
  tm_contact_result r;
  r.force = r.torque = tm_vec(0, 0, 0);
  r.friction_power = r.friction_heat = r.conducted = r.heat_tool = r.spring = 0.0;
  r.damping_power = r.particle_power = r.tool_power = r.late_friction = r.depth = r.inner = r.within = 0.0;
  r.contacts = r.faced = 0;
  return r;
}

TM_FN void tm_contact_sum(tm_contact_result *a, const tm_contact_result *b)
{
  a->force = tm_vec_add(a->force, b->force);
  a->torque = tm_vec_add(a->torque, b->torque);
  a->friction_power += b->friction_power;
  a->friction_heat += b->friction_heat;
  a->conducted += b->conducted;
  a->heat_tool += b->heat_tool;
  a->spring += b->spring;
  a->damping_power += b->damping_power;
  a->particle_power += b->particle_power;
  a->tool_power += b->tool_power;
  a->late_friction += b->late_friction;
  a->depth = tm_max(a->depth, b->depth);
  a->inner = tm_max(a->inner, b->inner);
  a->within = tm_max(a->within, b->within);
  a->contacts += b->contacts;
  a->faced += b->faced;
}

/* Sums of several threads into one place. */
TM_FN void tm_contact_add(double *sum, double value)
{
#if defined(__CUDA_ARCH__)
  atomicAdd(sum, value);
#else
#if defined(_OPENMP)
#pragma omp atomic
#endif
  *sum += value;
#endif
}
TM_FN void tm_contact_count(int *sum)
{
#if defined(__CUDA_ARCH__)
  atomicAdd(sum, 1);
#else
#if defined(_OPENMP)
#pragma omp atomic
#endif
  *sum += 1;
#endif
}

/* The sum before n is added. */
TM_FN int tm_contact_take(int *sum, int n)
{
#if defined(__CUDA_ARCH__)
  return atomicAdd(sum, n);
#else
  int before;
#if defined(_OPENMP)
#pragma omp atomic capture
#endif
  {
    before = *sum;
    *sum += n;
  }
  return before;
#endif
}

#endif
