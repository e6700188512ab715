namespace Rill
{
    /// <summary>Lets particles into a fluid; a <see cref="FluidPart"/>.</summary>
    interface IEmitter
    {
        /// <summary>Particles that were given up for want of room, as far as is known.</summary>
        int Blocked { get; }

        /// <summary>Material of what it lets in; null for that of its phase.</summary>
        FluidMaterialAsset Material { get; }

        /// <summary>Phase of what it lets in, if it has no material; else 0.</summary>
        int NamedPhase { get; }

        /// <summary>Gives what it does in the next step.</summary>
        /// <param name="frame">Frame of the fluid's box.</param>
        /// <param name="spacing">m.</param>
        /// <param name="step">Duration, s.</param>
        /// <param name="from">Fraction of the frame at which the step starts.</param>
        /// <param name="to">Fraction at which it ends.</param>
        /// <param name="frameTime">Time in which it came from where it was at the last frame's steps, s, above 0.</param>
        /// <param name="isTarget">Whether a drain gives it particles.</param>
        /// <returns>Whether it does anything.</returns>
        bool TryGetStep(in DomainFrame frame, float spacing, float step, float from, float to, float frameTime, bool isTarget,
            out EmitterStep result);

        /// <summary>Logs once what keeps it from letting in what is due.</summary>
        void ReportRefused();

        /// <summary>Goes on with particles of another spacing.</summary>
        void OnResampled();

        EmitterRecord Save(in DomainFrame frame);

        /// <param name="tolerance">Distance within which it is where it was, d.</param>
        void Load(in EmitterRecord record, in DomainFrame frame, float tolerance);
    }
}
