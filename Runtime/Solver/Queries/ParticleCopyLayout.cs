namespace Rill
{
    /// <summary>First word of each field in a copy of the particles; <see cref="ParticleAccess.NotCopied"/>, as an int, for a field that
    /// is not in it.</summary>
    readonly struct ParticleCopyLayout
    {
        /// <summary>First word of a field that is not copied.</summary>
        public const int Missing = unchecked((int)ParticleAccess.NotCopied);

        public readonly int PositionsAt, VelocitiesAt, IdsAt, PhasesAt;

        /// <summary>Number of words of the whole copy.</summary>
        public readonly long Words;

        /// <param name="capacity">Particles that each field holds.</param>
        public ParticleCopyLayout(ParticleFields fields, int capacity)
        {
            Words = ParticleAccess.CopyHeader;
            PositionsAt = AddField(fields, ParticleFields.Positions, 3L * capacity, ref Words);
            VelocitiesAt = AddField(fields, ParticleFields.Velocities, 3L * capacity, ref Words);
            IdsAt = AddField(fields, ParticleFields.Ids, capacity, ref Words);
            PhasesAt = AddField(fields, ParticleFields.Phases, capacity, ref Words);
        }

        // Capacity is at most 2^24, so that all fields end far below 2^31 words.
        static int AddField(ParticleFields fields, ParticleFields field, long words, ref long end)
        {
            if ((fields & field) == 0)
                return Missing;
            var at = (int)end;
            end += words;
            return at;
        }
    }
}
