using Unity.Collections;
using Unity.Mathematics;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Measures of a fluid at the end of one step, with neighbors found at those positions. The inspector, tests and
    /// reports all read this. Lengths in meters in the domain's frame, speeds in m/s, energies in joules.
    /// </summary>
    public struct FluidStatistics
    {
        /// <summary>words that <see cref="Quantity"/> numbers</summary>
        [GenerateHlsl("Statistics")] internal const int QuantityCount = 22;

        /// <summary>words that PhaseQuantity numbers</summary>
        [GenerateHlsl("Statistics")] internal const int PhaseQuantityCount = 8;

        /// <summary>words of all phases in _Statistics</summary>
        [GenerateHlsl("Statistics")] internal const int PhaseSums = PhaseMaterials.Phases * PhaseQuantityCount;

        /// <summary>first of them</summary>
        [GenerateHlsl("Statistics")] internal const int FirstPhaseSum = QuantityCount + 2 + ParticleBuffers.CounterCount;

        internal const int BlockSize = FirstPhaseSum + PhaseSums;

        /// <summary>Measured quantities: sums, then maxima.</summary>
        [GenerateHlsl("Statistics")]
        enum Quantity
        {
            Count,
            /// <summary>max(0, C)</summary>
            DensityError,
            /// <summary>particles away from the free surface</summary>
            Interior,
            /// <summary>abs(C) of those</summary>
            InteriorError,
            /// <summary>particles with at least 12 neighbors</summary>
            Surrounded,
            /// <summary>squared velocity minus the neighbors' mean, of those</summary>
            Jitter,
            SpeedSquared,
            /// <summary>and 8, 9</summary>
            Position,
            /// <summary>and 11, 12</summary>
            Velocity = Position + 3,
            /// <summary>more than 0.1 d beyond the contact offset of the walls and of colliders</summary>
            Escaped = Velocity + 3,
            /// <summary>particles closer than 0.05 d to another</summary>
            CoincidentPairs,
            Neighbors,
            /// <summary>the first maximum</summary>
            MaxError,
            MaxSpeedSquared,
            /// <summary>and 19, 20: largest x, y, z</summary>
            Furthest,
            /// <summary>most neighbors of a particle</summary>
            NeighborsMax = Furthest + 3,
        }

        /// <summary>Sums over the particles of a phase.</summary>
        [GenerateHlsl("Statistics", Prefix = "Phase")]
        enum PhaseQuantity
        {
            Count,
            SpeedSquared,
            /// <summary>and 3, 4</summary>
            Position,
            /// <summary>and 6, 7</summary>
            Velocity = Position + 3,
        }

        /// <summary>Fixed step since the last reset that was measured; 0 is the state before the first.</summary>
        public int step;
        /// <summary>Fluid time of that step at the present step rate, s.</summary>
        public double time;

        /// <summary>Particles alive when it was measured.</summary>
        public int particles;
        /// <summary>Particles put in by volumes and from code, since the reset. With those of emitters: drained, non-finite and alive ones.</summary>
        public int added;
        /// <summary>Particles let in by emitters, since the reset.</summary>
        public int emitted;
        /// <summary>Particles taken out by drains, by scripts or since their lifetime was over, since the reset.</summary>
        public int drained;
        /// <summary>Particles that came from a connected fluid, or came back from outside the box, since the reset.</summary>
        public int handedIn;
        /// <summary>Particles that went to a connected fluid, or were kept as the box moved away, since the reset.</summary>
        public int handedOut;
        /// <summary>Particles due from emitters and given up since they found no room for a second, since the reset.</summary>
        public int blocked;
        /// <summary>Particles due from emitters that have found no room so far.</summary>
        public int waiting;
        /// <summary>Particles that drains took and emitters have not let in again so far.</summary>
        public int recycling;
        /// <summary>Particles refused for want of capacity, since the reset.</summary>
        public int refused;
        /// <summary>Particles removed because their position was not finite, since the reset.</summary>
        public int nonFinite;
        /// <summary>Particles that had more neighbors than their list holds, in the last substep.</summary>
        public int neighborOverflow;
        /// <summary>Most entries that such a particle's list would have needed; 0 without one.</summary>
        public int neighborOverflowMax;
        /// <summary>Particles more than 0.1 d beyond where the walls let a center go.</summary>
        public int escaped;
        /// <summary>Particles closer than 0.05 d to another.</summary>
        public int coincident;

        /// <summary>C+: mean of max(0, ρ/ρ0 − 1), boundary density included.</summary>
        public float densityError;
        /// <summary>Value of max(0, ρ/ρ0 − 1) that one particle in a thousand exceeds.</summary>
        public float densityError999;
        /// <summary>Largest max(0, ρ/ρ0 − 1).</summary>
        public float densityErrorMax;
        /// <summary>Mean of |ρ/ρ0 − 1| away from the free surface.</summary>
        public float interiorError;
        /// <summary>2 × mean height × floor area over the fluid's rest volume: 1 for still water that fills its floor.</summary>
        public float volumeRatio;
        /// <summary>Rms of velocity minus the neighbors' mean, m/s.</summary>
        public float jitter;
        /// <summary>Rms speed, m/s.</summary>
        public float speed;
        /// <summary>Largest speed of a particle, m/s.</summary>
        public float speedMax;
        /// <summary>Mean number of neighbors of a particle, within the support radius.</summary>
        public float neighborsMean;
        /// <summary>Largest number of neighbors of a particle, within the support radius.</summary>
        public int neighborsMax;
        /// <summary>Mass of all particles, kg.</summary>
        public float mass;
        /// <summary>Center of mass in the domain's frame, m.</summary>
        public float3 centerOfMass;
        /// <summary>Largest coordinate of a particle along each axis, m.</summary>
        public float3 furthest;
        /// <summary>Momentum, kg m/s.</summary>
        public float3 momentum;
        /// <summary>Kinetic energy, J.</summary>
        public float kineticEnergy;
        /// <summary>Potential energy with respect to the domain's lowest corner, J.</summary>
        public float potentialEnergy;

        /// <summary>Most that the last pass for the dynamic viscosity changed a velocity by, m/s; 0 without. Up to the viscosity that the
        /// passes solve, less than this is left.</summary>
        public float viscosityChange;

        /// <summary>Relaxation ω of the last step.</summary>
        public float relaxation;
        /// <summary>Whether the ω asked for was above what was measured stable, or below in deep water.</summary>
        public bool relaxationClamped;
        /// <summary>Substeps of the last step: more than asked for where gravity is strong, the step long or the spacing small.</summary>
        public int substeps;
        /// <summary>Fluid time that the catch-up cap dropped since the reset, s.</summary>
        public double droppedTime;

        internal PhaseValues phases;

        /// <summary>Returns the volume at rest of the particles of one phase, m³. Where neither materials nor
        /// <see cref="FluidSimulation.TrackPhases"/> asks for phases, all particles count as phase 0.</summary>
        /// <param name="phase">0 to 7.</param>
        /// <exception cref="System.ArgumentOutOfRangeException">No phase has this number.</exception>
        public float VolumeOf(int phase) => phases[phase];

        /// <summary>Kinetic and potential energy together; what an elastic fluid has stored in its stretch is not counted.</summary>
        public float Energy => kineticEnergy + potentialEnergy;

        /// <summary>Returns the main figures in one line, with units.</summary>
        public override string ToString() => Invariant($"step {step} at {time:0.###} s: {particles} particles, density error {densityError:P2} (") +
            Invariant($"99.9 % below {densityError999:P1}, max {densityErrorMax:P0}), volume {volumeRatio:0.000} of rest, ") +
            Invariant($"speed rms {speed:0.000}, jitter {jitter:0.000}, max {speedMax:0.000} m/s");

        /// <param name="block">As Statistics.compute writes it.</param>
        internal static FluidStatistics From(NativeArray<uint> block, SolverLayout layout, in StepInput input)
        {
            float d = layout.Spacing;
            float count = Value(block, Quantity.Count);
            float perParticle = 1f / math.max(count, 1f);
            float3 meanPosition = Vector(block, (int)Quantity.Position) * perParticle * d;
            float3 box = layout.DomainSize * d;
            var statistics = new FluidStatistics
            {
                step = (int)block[QuantityCount + 1],
                particles = (int)count,
                added = Counter(block, ParticleCounter.Added),
                emitted = Counter(block, ParticleCounter.Emitted),
                drained = Counter(block, ParticleCounter.Drained),
                handedIn = Counter(block, ParticleCounter.HandedIn),
                handedOut = Counter(block, ParticleCounter.HandedOut),
                blocked = Counter(block, ParticleCounter.Blocked),
                waiting = Counter(block, ParticleCounter.Waiting),
                recycling = Counter(block, ParticleCounter.Recycling),
                refused = Counter(block, ParticleCounter.Refused),
                // and those that the next sort leaves out: of what was removed since, it was taken back in advance
                nonFinite = Counter(block, ParticleCounter.NonFinite) + Counter(block, ParticleCounter.Alive) - (int)count,
                neighborOverflow = Counter(block, ParticleCounter.Overflow),
                neighborOverflowMax = Counter(block, ParticleCounter.MaxNeighbors),
                escaped = (int)Value(block, Quantity.Escaped),
                coincident = (int)Value(block, Quantity.CoincidentPairs),
                densityError = Value(block, Quantity.DensityError) * perParticle,
                densityError999 = math.min(math.asfloat(block[QuantityCount]), Value(block, Quantity.MaxError)),      // of a bin, its upper end
                densityErrorMax = Value(block, Quantity.MaxError),
                interiorError = Value(block, Quantity.InteriorError) / math.max(Value(block, Quantity.Interior), 1f),
                volumeRatio = 2f * meanPosition.y * box.x * box.z / math.max(count * d * d * d, 1e-30f),
                jitter = d * math.sqrt(Value(block, Quantity.Jitter) / math.max(Value(block, Quantity.Surrounded), 1f)),
                speed = d * math.sqrt(Value(block, Quantity.SpeedSquared) * perParticle),
                speedMax = d * math.sqrt(Value(block, Quantity.MaxSpeedSquared)),
                neighborsMean = Value(block, Quantity.Neighbors) * perParticle,
                neighborsMax = (int)Value(block, Quantity.NeighborsMax),
                furthest = Vector(block, (int)Quantity.Furthest) * d,
                viscosityChange = d * math.asfloat((uint)Counter(block, ParticleCounter.ViscosityChange)),
            };
            statistics.time = statistics.step * (double)input.timeStep;
            statistics.Weigh(block, d, input);
            return statistics;
        }

        // Mass and what it moves with, by phase where phases were measured.
        void Weigh(NativeArray<uint> block, float d, in StepInput input)
        {
            float measured = 0f, volume = d * d * d;
            for (int phase = 0; phase < PhaseMaterials.Phases; phase++)
                measured += math.asfloat(block[PhaseSum(phase, PhaseQuantity.Count)]);
            if (measured > 0f)
            {
                for (int phase = 0; phase < PhaseMaterials.Phases; phase++)
                {
                    float count = math.asfloat(block[PhaseSum(phase, PhaseQuantity.Count)]);
                    phases[phase] = count * volume;
                    AddMass(input.phases.Density(phase, input.material) * volume, d, count,
                        math.asfloat(block[PhaseSum(phase, PhaseQuantity.SpeedSquared)]),
                        Vector(block, PhaseSum(phase, PhaseQuantity.Position)), Vector(block, PhaseSum(phase, PhaseQuantity.Velocity)));
                }
            }
            else
            {
                float count = Value(block, Quantity.Count);
                phases[0] = count * volume;
                AddMass(input.material.density * volume, d, count, Value(block, Quantity.SpeedSquared),
                    Vector(block, (int)Quantity.Position), Vector(block, (int)Quantity.Velocity));
            }
            centerOfMass /= math.max(mass, 1e-30f);
            potentialEnergy = -mass * math.dot(input.gravity, centerOfMass);
        }

        // Leaves the sum of mass times position in centerOfMass.
        void AddMass(float particle, float d, float count, float speedSquared, float3 positions, float3 velocities)
        {
            mass += particle * count;
            centerOfMass += positions * (particle * d);
            momentum += velocities * (particle * d);
            kineticEnergy += 0.5f * particle * speedSquared * d * d;
        }

        static int PhaseSum(int phase, PhaseQuantity quantity) => FirstPhaseSum + phase * PhaseQuantityCount + (int)quantity;

        static float Value(NativeArray<uint> block, Quantity quantity) => math.asfloat(block[(int)quantity]);

        static float3 Vector(NativeArray<uint> block, int first)
            => new float3(math.asfloat(block[first]), math.asfloat(block[first + 1]), math.asfloat(block[first + 2]));

        static int Counter(NativeArray<uint> block, ParticleCounter counter) => (int)block[QuantityCount + 2 + (int)counter];
    }
}
