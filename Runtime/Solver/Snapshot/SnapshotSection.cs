namespace Rill
{
    /// <summary>Parts of a snapshot. The numbers stand in files: new ones go to the end, and none changes its meaning without a new
    /// version.</summary>
    enum SnapshotSection : uint
    {
        /// <summary>A <see cref="SolverRecord"/>.</summary>
        Solver = 1,
        /// <summary>A <see cref="TimeRecord"/>; not in the snapshot of a solver without a component.</summary>
        Time,
        /// <summary>uint [16], by <see cref="ParticleCounter"/>.</summary>
        Counters,
        /// <summary>float4 [particles], d.</summary>
        Positions,
        /// <summary>float4 [moved], d.</summary>
        StartPositions,
        /// <summary>float4 [particles], d/s; w density.</summary>
        Velocities,
        /// <summary>uint [particles].</summary>
        Ids,
        /// <summary>uint [particles], see ParticleTags.hlsl.</summary>
        Tags,
        /// <summary>uint [moved], entries of each particle's list.</summary>
        NeighborCounts,
        /// <summary>uint, the entries one after the other, particle by particle.</summary>
        Neighbors,
        /// <summary>A <see cref="RestRecord"/>.</summary>
        Rest,
        /// <summary>uint [regions * 5].</summary>
        RegionMotion,
        /// <summary>uint [regions].</summary>
        QuietSteps,
        /// <summary>A <see cref="CoarseRecord"/>.</summary>
        Coarse,
        /// <summary>uint [coarse cells].</summary>
        CoarseSurface,
        /// <summary>float [coarse cells].</summary>
        CoarseErrors,
        /// <summary>float [coarse cells], d².</summary>
        FlowPotential,
        /// <summary>float [coarse cells], d².</summary>
        ErrorPotential,
        /// <summary>An <see cref="ExtrapolationRecord"/>.</summary>
        Extrapolation,
        /// <summary>uint4 [moved].</summary>
        Means,
        /// <summary>Symmetric tensors [moved], six floats each.</summary>
        Conformation,
        /// <summary>uint [emitters * 16]; 8 before version 4.</summary>
        EmitterStates,
        /// <summary>uint [drains * 4].</summary>
        DrainStates,
        /// <summary><see cref="FieldRegion"/> [fields].</summary>
        Fields,
        /// <summary><see cref="EmitterRecord"/> [emitters].</summary>
        Emitters,
        /// <summary><see cref="DrainRecord"/> [drains].</summary>
        Drains,
        /// <summary><see cref="ColliderRecord"/> [colliders].</summary>
        Colliders,
        /// <summary>float, s: length of the substep that the flow's potential is of, since version 3.</summary>
        FlowTime,
        /// <summary>A <see cref="CallsRecord"/>, since version 5.</summary>
        Calls,
        /// <summary><see cref="ForceRecord"/> [colliders], since version 5.</summary>
        Forces,
        /// <summary>A <see cref="ReactionsRecord"/>, since version 5.</summary>
        Reactions,
        /// <summary>uint, what the fluid did to colliders since it was last asked for, since version 5.</summary>
        ReactionSums,
        /// <summary>uint, the same of before, which was asked for and had not come, since version 5.</summary>
        ReactionsTaken,
        /// <summary><see cref="TakenRecord"/> [colliders], since version 5.</summary>
        TakenColliders,
        /// <summary><see cref="SnapshotBody"/> [bodies], one after the other, since version 5.</summary>
        Bodies,
        /// <summary>uint [cells + 1], where the particles lie that the last step sorted, for what is asked before the next; since version
        /// 5.</summary>
        CellStarts,
        /// <summary>float [moved], see PhaseSlip.hlsl, since version 5.</summary>
        Slips,
        /// <summary>float4 [friction nodes], d, since version 5.</summary>
        FrictionChange,
        /// <summary>float4 [2 friction cells], d², since version 5.</summary>
        FrictionStress,
        /// <summary>float4 [2 friction cells], d², since version 5.</summary>
        FrictionStressAfter,
    }
}
