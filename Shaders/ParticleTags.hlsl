// A particle's tag: its phase in the highest byte, below it the step after which it is gone, 0 for never. The step is kept
// modulo 2^24, which at 60 steps a second is 77 hours.
#ifndef RILL_PARTICLE_TAGS_INCLUDED
#define RILL_PARTICLE_TAGS_INCLUDED

static const uint kTagSteps = 0x00FFFFFFu, kTagPhaseShift = 24;

bool IsOver(uint tag, uint step)
{
    uint last = tag & kTagSteps;
    uint since = (step - last) & kTagSteps;
    return last != 0 && since != 0 && since < 0x00800000u;
}

#endif
