// Indirect arguments for kernels and draws over all particles.
#ifndef RILL_ARGUMENTS_INCLUDED
#define RILL_ARGUMENTS_INCLUDED

#include "../Generated/Arguments.hlsl"

static const uint kDrawArgumentsSize = 16;      // GraphicsBuffer.IndirectDrawArgs

// GraphicsBuffer.IndirectDrawArgs of one instance, where a draw looks for its first command; groups x, y, z of a dispatch and the
// count; the draw's third command: the same of two instances, one for each eye.
void StoreArguments(RWByteAddressBuffer arguments, uint count)
{
    arguments.Store4(kDrawArgumentsSize * kMonoCommand, uint4(count * kVerticesPerParticle, 1, 0, 0));
    arguments.Store4(kDispatchArgumentsAt, uint4(GroupsFor(count), count));
    arguments.Store4(kDrawArgumentsSize * kStereoCommand, uint4(count * kVerticesPerParticle, 2, 0, 0));
}

#endif
