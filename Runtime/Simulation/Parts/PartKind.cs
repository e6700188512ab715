namespace Rill
{
    /// <summary>Kind of a <see cref="FluidPart"/>.</summary>
    enum PartKind { Emitter, Drain, ForceField, Probe, Detector, SmokeSource }
}
