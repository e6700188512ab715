// Blends the velocities of particles deep in the water to the flow of the coarse grid, which calms the noise of the passes there.
// Include after CoarseDisplacement.hlsl.
#ifndef RILL_DEEP_FLOW_INCLUDED
#define RILL_DEEP_FLOW_INCLUDED

StructuredBuffer<float4> _DeepFlow;     // [coarse cells], xyz flow at the cell's center, d in a substep; w 1 if the cell is deep
float _FlowBlend;                       // part of a particle's departure from the flow that a substep takes; 0 for none

// Change of the velocity of a particle at p by the flow around where the substep leads it. At the domain's walls the flow along their normals is
// 0. Each cell beside a deep one has water, so the flow is trilinear wherever it counts.
float3 ChangeToFlow(float3 p, float3 velocity)
{
    float3 position = AlongFlow(p, velocity);
    CornerCells cells = CellsAround(position);
    float4 flow = 0.0;
    [unroll]
    for (int row = 0; row < 4; row++)
    {
        float weight;
        int2 pair = CornerRow(cells, row, weight);
        flow += weight * lerp(_DeepFlow[pair.x], _DeepFlow[pair.y], cells.fraction.x);
    }
    float3 along = position * _InverseCoarseSize;
    flow.xyz *= saturate(2.0 * along) * saturate(2.0 * (float3(_CoarseCounts) - along));
    return _FlowBlend * flow.w * (flow.xyz * _InverseTimeStep - velocity);
}

#endif
