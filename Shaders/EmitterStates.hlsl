// What is known of each emitter on the GPU alone: _EmitterStates, uint [emitters * kEmitterWords], = Emitters.State in Emitters.cs.
#ifndef RILL_EMITTER_STATES_INCLUDED
#define RILL_EMITTER_STATES_INCLUDED

static const uint kEmitterWords = 8;
static const uint kEmitterWaiting = 0;      // particles due that had no room yet
static const uint kEmitterRecycled = 1;     // particles that drains sent here and that are not back yet
static const uint kEmitterCursor = 2;       // place at which a volume goes on to be filled, or a cross-section to be searched
static const uint kEmitterEmitted = 3;      // since the reset
static const uint kEmitterRefused = 4;      // for want of capacity, since the reset
static const uint kEmitterBlocked = 5;      // given up for want of room, since the reset
static const uint kEmitterInCollider = 6;      // places tried in this step that a collider covers; 0 between steps
static const uint kEmitterShut = 7;         // steps in a row up to the last in which colliders covered all places tried; 0 where none was

#endif
