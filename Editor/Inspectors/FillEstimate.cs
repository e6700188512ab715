using System;
using Unity.Mathematics;

namespace Rill.Editor
{
    /// <summary>How many particles volumes hold, before they are filled.</summary>
    static class FillEstimate
    {
        /// <returns>0 where nothing can be filled.</returns>
        public static double Particles(FluidVolume volume, float spacing)
        {
            if (!(spacing > 0f))
                return 0.0;
            double ofOne = (double)spacing * spacing * spacing;
            switch (volume.Shape)
            {
                case VolumeShape.Box:
                    int3 counts = math.max(volume.LatticeCounts(spacing), 0);
                    return (double)counts.x * counts.y * counts.z;
                case VolumeShape.Sphere:
                    return 4.0 / 3.0 * Math.PI * Math.Pow(Math.Max(volume.Radius, 0f), 3.0) / ofOne;
                default:
                    double scale = Math.Abs(volume.transform.lossyScale.x);
                    return volume.Field != null ? volume.Field.Volume * scale * scale * scale / ofOne : 0.0;
            }
        }

        /// <summary>Number of particles in all volumes of a simulation.</summary>
        public static double Particles(FluidSimulation fluid)
        {
            double particles = 0.0;
            foreach (FluidVolume volume in fluid.GetComponentsInChildren<FluidVolume>())
                particles += Particles(volume, fluid.ParticleSpacing);
            return particles;
        }
    }
}
