// Indirect arguments for kernels and draws over all particles.
#ifndef RILL_ARGUMENTS_INCLUDED
#define RILL_ARGUMENTS_INCLUDED

static const uint kVerticesPerParticle = 6;     // two triangles of a quad, = ParticleRenderer.VerticesPerParticle

// Bytes 0-15: GraphicsBuffer.IndirectDrawArgs of one instance, where a draw looks for its first command. Bytes 16-31
// (GpuBuffer.DispatchArgumentsAt): groups x, y, z of a dispatch and the count. Bytes 32-47, the draw's third command
// (StereoInstancing.StereoCommand): the same of two instances, one for each eye.
void StoreArguments(RWByteAddressBuffer arguments, uint count)
{
    arguments.Store4(0, uint4(count * kVerticesPerParticle, 1, 0, 0));
    arguments.Store4(16, uint4(GroupsFor(count), count));
    arguments.Store4(32, uint4(count * kVerticesPerParticle, 2, 0, 0));
}

#endif
