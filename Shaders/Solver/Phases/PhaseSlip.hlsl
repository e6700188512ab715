// How a particle among others of another density moves relative to the coarse grid, whose cells know their mean density alone: drops and
// bubbles smaller than a cell would hover there. What mixes moves as one. Include after PhaseMass.hlsl.
//
//   _Slips           [particles]  i/o  float, factor of the grid's displacement; 1 where at least half of the neighbors have its density
#ifndef RILL_PHASE_SLIP_INCLUDED
#define RILL_PHASE_SLIP_INCLUDED

static const float kAddedMass = 0.5;    // of the fluid that a sphere displaces, which has to move with it

// Sums over a particle's neighbors.
struct SlipSums
{
    float others;       // of another density
    float mass;         // of those
};

void AddSlip(inout SlipSums sums, uint i, uint j)
{
    float mass = RelativeMass(j);
    bool isOther = mass != RelativeMass(i) && !AreMixing(i, j);
    sums.others += isOther ? 1.0 : 0.0;
    sums.mass += isOther ? mass : 0.0;
}

// A sphere of density rho in a fluid of rho' accelerates by (rho' - rho) / (rho + rho' / 2) times what gravity and pressure leave, more or
// less than the fluid. 'count' neighbors.
float SlipOf(SlipSums sums, uint i, uint count)
{
    float own = RelativeMass(i);
    float around = sums.mass / max(sums.others, 1.0);
    float alone = max(2.0 * sums.others / (count + 1.0) - 1.0, 0.0);
    return 1.0 + alone * (around - own) / (own + kAddedMass * around);
}

#endif
