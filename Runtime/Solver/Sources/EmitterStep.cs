using Unity.Mathematics;

namespace Rill
{
    /// <summary>Work of one emitter in one step. Lengths in d, times in seconds, directions in the domain's frame.</summary>
    struct EmitterStep
    {
        /// <summary>instead of a limit: what finds no room was not due, and is not counted as given up</summary>
        [GenerateHlsl("Emitters")] public const int NoneWaits = int.MaxValue;

        const float MinPressDepth = 2f;     // d

        /// <summary>Its number, below <see cref="StepSources.MaxEmitters"/>.</summary>
        public int number;
        public EmitterPositions positions;
        /// <summary>At the start and at the end of the step.</summary>
        public RigidPose start, end;
        /// <summary>d/s, along each place's direction of flow.</summary>
        public float speed;
        /// <summary>Parts of the emitter's own velocity, d/s, and of its angular velocity, rad/s, that particles take along.</summary>
        public float3 velocity, spin;
        /// <summary>Cosine of the largest angle between a particle's velocity and its direction of flow.</summary>
        public float cosSpread;
        /// <summary>Particles due in this step, and how many were before since the reset.</summary>
        public int due;
        public uint firstSerial;
        /// <summary>At the end of the step, s, since the first particle due was emitted; and the time between two.</summary>
        public float firstAge, interval;
        /// <summary>Positions of the cross-section that are filled in turn, 1 to the number of positions.</summary>
        public int layerPositions;
        /// <summary>Positions tried in this step, 1 to <see cref="Emitters.MaxCandidates"/>.</summary>
        public int candidates;
        /// <summary>Particles that wait for room at most; what is beyond is given up. Or <see cref="NoneWaits"/>.</summary>
        public int maxWaiting;
        /// <summary>Whether it fills what lacks of a level, at a border.</summary>
        public bool HoldsLevel => maxWaiting == NoneWaits;
        /// <summary>Whether it does nothing from here on.</summary>
        public bool isLast;
        /// <summary>0 to 255; 0 for none.</summary>
        public int phase;
        /// <summary>Steps that a particle lives; 0 for ever.</summary>
        public int lifetimeSteps;

        /// <summary>Tag of the particles that are emitted in a step; see ParticleTags.hlsl.</summary>
        public uint TagIn(uint step)
        {
            if (lifetimeSteps == 0)
                return (uint)phase << ParticleTags.PhaseShift;
            uint last = (step + (uint)lifetimeSteps) & ParticleTags.StepMask;
            return (uint)phase << ParticleTags.PhaseShift | math.max(last, 1u);
        }

        /// <summary>Chooses the positions that a step tries, from the particles a second that are asked for.</summary>
        /// <param name="perSecond">Particles a second.</param>
        /// <param name="step">Length of the step, s.</param>
        public void ChoosePositions(float perSecond, float step)
        {
            int count = positions.Count;
            if (positions.FillsVolume)
            {
                layerPositions = count;
                candidates = math.min(count, Emitters.MaxCandidates);
                return;
            }
            // So many that they fill a layer in the time in which it moves on by a spacing: the flow is as wide as it needs
            // to be at rest density, and no wider.
            float needed = math.ceil(perSecond / speed - 1e-3f);
            layerPositions = positions.UsesAllPositions ? count : (int)math.clamp(needed, 1f, count);
            candidates = CandidatesIn(step);
        }

        /// <summary>Whether it lets in at the end of each substep. What fills a volume has no stream that a step would tear: it does so
        /// once.</summary>
        public bool EmitsInSubsteps => !positions.FillsVolume;

        /// <summary>Returns its part of one of the equal substeps of this step. All of them together let in as much as the step.</summary>
        /// <param name="index">Index of the substep.</param>
        /// <param name="count">Substeps.</param>
        /// <param name="step">Length of the whole step, s.</param>
        public EmitterStep Part(int index, int count, float step)
        {
            if (count == 1)
                return this;
            float length = step / count, after = (count - 1 - index) * length;
            int before = index > 0 ? DueBefore(after + length) : 0, until = index < count - 1 ? DueBefore(after) : due;
            EmitterStep part = this;
            part.start = RigidPose.Between(start, end, index / (float)count);
            part.end = RigidPose.Between(start, end, (index + 1) / (float)count);
            part.due = until - before;
            part.firstSerial = firstSerial + (uint)before;
            part.firstAge = firstAge - before * interval - after;
            part.candidates = CandidatesIn(length);
            return part;
        }

        /// <summary>How far before the outlet it presses water away, d: what lies there moves along with what is let in. 0 for what presses
        /// nothing away: a volume that is filled where there is room, and a surface that flows in all directions.</summary>
        /// <param name="step">s.</param>
        public float PressDepth(float step) => positions.HalfSection.x > 0f ? MinPressDepth + speed * step : 0f;

        /// <summary>The cells that what lies before the outlet may be in.</summary>
        /// <param name="depth">d, from the outlet.</param>
        public void CellsBefore(SolverLayout layout, float depth, out int3 from, out int3 counts)
        {
            float3 low = float.MaxValue, high = float.MinValue;
            Enclose(start, depth, ref low, ref high);
            Enclose(end, depth, ref low, ref high);
            int3 last = layout.CellCounts - 1;
            from = math.clamp((int3)math.floor(low / layout.CellSize), 0, last);
            counts = math.clamp((int3)math.floor(high / layout.CellSize), 0, last) - from + 1;
        }

        // Widens a box to a pose's outlet and what lies up to so far before it, and as far beside it.
        void Enclose(in RigidPose pose, float depth, ref float3 low, ref float3 high)
        {
            float3 x = math.mul(pose.rotation, new float3(1f, 0f, 0f)), y = math.mul(pose.rotation, new float3(0f, 1f, 0f));
            float2 half = positions.HalfSection.y > 0f ? positions.HalfSection : positions.HalfSection.x;
            float3 reach = math.abs(x) * half.x + math.abs(y) * half.y + depth;
            low = math.min(low, pose.position - reach);
            high = math.max(high, pose.position + reach);
        }

        // Those that were emitted longer ago than that at the end of the step, s.
        int DueBefore(float age) => interval > 0f ? (int)math.clamp(math.ceil((firstAge - age) / interval), 0f, due)
            : firstAge > age ? due : 0;

        int CandidatesIn(float duration)
            => (int)math.min(math.ceil(positions.Count * speed * duration) + 1f, Emitters.MaxCandidates);

        /// <summary>Lets particles take the emitter's own velocity along.</summary>
        /// <param name="fraction">0 to 1.</param>
        /// <param name="duration">Time in which it came from start to end, s, above 0; not that of the step where frames and steps differ.</param>
        /// <param name="most">Maximum that a particle takes of each, d/s.</param>
        public void Inherit(float fraction, float duration, float most)
        {
            float4 turn = math.mul(end.rotation, math.conjugate(start.rotation)).value;
            turn = turn.w < 0f ? -turn : turn;
            float angle = 2f * math.atan2(math.length(turn.xyz), turn.w);
            velocity = fraction * AtMost((end.position - start.position) / duration, most);
            spin = fraction * AtMost(math.normalizesafe(turn.xyz) * (angle / duration), most / math.max(positions.Radius, 1f));
        }

        /// <summary>Steps until every place was tried where none has room: the first tries those that the flow would use.</summary>
        public int StepsOfASearch => 1 + (positions.Count + candidates - 1) / candidates;

        /// <summary>Radius of a ball around the end's position that holds all that this step can emit, d.</summary>
        public float Reach(float step) => positions.Radius + (speed + math.length(velocity) + math.length(spin) * positions.Radius) * step
            + math.distance(start.position, end.position) + 1f;

        static float3 AtMost(float3 vector, float length)
        {
            float own = math.length(vector);
            return own > length ? vector * (length / own) : vector;
        }
    }
}
