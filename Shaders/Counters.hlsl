// Entries of the solver's counter buffer.
#ifndef RILL_COUNTERS_INCLUDED
#define RILL_COUNTERS_INCLUDED

// _Counters, = ParticleCounter in ParticleBuffers.cs
static const uint kAlive = 0;               // particles at the start of the step
static const uint kSorted = 1;              // of those, with a finite position: particles of this step
static const uint kNextId = 2;
static const uint kRefused = 3;             // did not fit the capacity, since reset
static const uint kNonFinite = 4;           // culled, since reset
static const uint kOverflow = 5;            // particles of this step with more neighbors than the list holds
static const uint kMaxNeighbors = 6;       // most neighbors of such a particle
// Since the reset, kAdded + kEmitted = kDrained + kNonFinite + kAlive at the end of a step.
static const uint kAdded = 7;               // by a volume or by code
static const uint kEmitted = 8;
static const uint kDrained = 9;
static const uint kBlocked = 10;            // due from an emitter and given up, since there was no room for a second
static const uint kWaiting = 11;            // due from an emitter and without room so far
static const uint kRecycling = 12;          // drained and not yet back from an emitter
static const uint kMoved = 13;              // took part in the last step: the first of those alive
// Of the viscosity's last solve, as float bits:
static const uint kViscosityBound = 14;     // of what neighbors brake a particle by, half the largest eigenvalue of the sum in ImplicitViscosity.compute
static const uint kViscosityChange = 15;    // largest change of a velocity in its last pass, d/s

#endif
