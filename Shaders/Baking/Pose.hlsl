// Moves the vertices of a mesh that deforms to where their bones are.
//
//   _RestVertices  [vertices]     in   before bones act on them, m
//   _VertexBones   [vertices]     in   the four bones of each, and their weights
//   _Bones         [3 per bone]   in   rows of the matrix to the grid's frame, m
//   _VerticesMade  [vertices]     out  m
#ifndef RILL_POSE_INCLUDED
#define RILL_POSE_INCLUDED

StructuredBuffer<float3> _RestVertices;
StructuredBuffer<VertexBones> _VertexBones;
StructuredBuffer<float4> _Bones;
RWStructuredBuffer<float3> _VerticesMade;

[numthreads(kGroup, 1, 1)]
void PoseVertices(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint i = ItemOf(group, thread);
    if (i >= _Count)
        return;
    float4 rest = float4(_RestVertices[i], 1.0);
    VertexBones own = _VertexBones[i];
    float3 posed = 0.0;
    [unroll]
    for (uint k = 0; k < 4; k++)
        if (own.weights[k] > 0.0)
        {
            uint row = 3 * own.bones[k];
            posed += own.weights[k] * float3(dot(_Bones[row], rest), dot(_Bones[row + 1], rest), dot(_Bones[row + 2], rest));
        }
    _VerticesMade[i] = posed;
}

#endif
