// A particle's tag: its phase in the highest byte, below it the step after which it is gone, 0 for never. The step is kept
// modulo 2^24, which at 60 steps a second is 77 hours.
#ifndef RILL_PARTICLE_TAGS_INCLUDED
#define RILL_PARTICLE_TAGS_INCLUDED

#include "../../Generated/ParticleTags.hlsl"

bool IsOver(uint tag, uint step)
{
    uint last = tag & kTagStepMask;
    uint since = (step - last) & kTagStepMask;
    return last != 0 && since != 0 && since < 0x00800000u;
}

#endif
