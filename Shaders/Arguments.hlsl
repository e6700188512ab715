// Indirect arguments for kernels and draws over all particles.
#ifndef RILL_ARGUMENTS_INCLUDED
#define RILL_ARGUMENTS_INCLUDED

static const uint kVerticesPerParticle = 6;     // two triangles of a quad, = ParticleRenderer.VerticesPerParticle

// Bytes 0-15: groups x, y, z of a dispatch and the count. Bytes 16-31: GraphicsBuffer.IndirectDrawArgs of one instance.
void StoreArguments(RWByteAddressBuffer arguments, uint count)
{
    arguments.Store4(0, uint4(GroupsFor(count), count));
    arguments.Store4(16, uint4(count * kVerticesPerParticle, 1, 0, 0));
}

#endif
