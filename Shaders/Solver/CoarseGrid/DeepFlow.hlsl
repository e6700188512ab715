// Finds how the coarse grid changes a particle's velocity before the prediction: by the projection's displacement and, deep in the water, by a
// blend to the grid's flow, which calms the noise of the passes. Include after CoarseDisplacement.hlsl and CoarseSlip.hlsl.
#ifndef RILL_DEEP_FLOW_INCLUDED
#define RILL_DEEP_FLOW_INCLUDED

#ifndef RILL_MATERIALS      // the mean flow of two liquids is that of neither

StructuredBuffer<float4> _DeepFlow;     // [coarse cells], xyz flow at the cell's center, d in a substep; w 1 if the cell is deep
float _FlowBlend;                       // part of a particle's departure from the flow that a substep takes

// Change by the flow around where the substep leads the particle. At the domain's walls the flow along their normals is 0. Each cell beside a
// deep one has water, so the flow is trilinear wherever it counts.
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

float3 ChangeByGrid(uint i, float3 p, float4 velocity)
{
    float3 change = SlipOf(i) * ProjectedDisplacement(p, velocity) * _InverseTimeStep;
#ifndef RILL_MATERIALS
    change += ChangeToFlow(p, velocity.xyz);
#endif
    return change;
}

#endif
