using System;
using UnityEngine;

namespace Rill
{
    /// <summary>How the air above a fluid moves and what its smoke does. Temperatures are in degrees Celsius.</summary>
    [Serializable]
    public struct SmokeSettings
    {
        internal const float AbsoluteZero = -273.15f;
        internal const float MaxTemperature = 3000f, MaxDensity = 1000f, MaxVorticity = 2f;

        /// <summary>Side of a cell of the grid, m: finer shows smaller eddies and costs the third power. 0: the particle spacing. 0 to 10. A
        /// grid has at most 1,048,576 cells; a larger one gets larger cells.</summary>
        [Tooltip("Side of a cell of the grid, m: finer shows smaller eddies and costs the third power. 0: the particle spacing. 0 to 10. " +
            "A grid has at most 1,048,576 cells; a larger one gets larger cells.")]
        [Range(0f, 10f)] public float cellSize;

        /// <summary>Time in which smoke thins to 37 % (1/e), s. 0: it stays. 0 to 1000.</summary>
        [Tooltip("Time in which smoke thins to 37 % (1/e), s. 0: it stays. 0 to 1000.")]
        [Range(0f, 1000f)] public float lifetime;

        /// <summary>Time in which hot air cools to 37 % (1/e) of what it is warmer, s. 0: it stays hot. 0 to 1000.</summary>
        [Tooltip("Time in which hot air cools to 37 % (1/e) of what it is warmer, s. 0: it stays hot. 0 to 1000.")]
        [Range(0f, 1000f)] public float cooling;

        /// <summary>Strength of vorticity confinement, 1/s: gives back eddies that the grid damps; above 0.5 it adds some. 0 to 2.</summary>
        [Tooltip("Strength of vorticity confinement, 1/s: gives back eddies that the grid damps; above 0.5 it adds some. 0 to 2.")]
        [Range(0f, MaxVorticity)] public float vorticity;

        /// <summary>Temperature of the fresh air, °C. -100 to 1000.</summary>
        [Tooltip("Temperature of the fresh air, °C. -100 to 1000.")]
        public float airTemperature;

        /// <summary>How dense steam over the fluid's surface is: extinction of light, 1/m. 0: no steam. 0 to 1000.</summary>
        [Tooltip("How dense steam over the fluid's surface is: extinction of light, 1/m. 0: no steam. 0 to 1000.")]
        [Range(0f, MaxDensity)] public float steam;

        /// <summary>Temperature of that steam, °C. -100 to 3000.</summary>
        [Tooltip("Temperature of that steam, °C. -100 to 3000.")]
        public float steamTemperature;

        /// <summary>Sides of the box through which air flows freely; the others are walls.</summary>
        [Tooltip("Sides of the box through which air flows freely; the others are walls.")]
        public BoxWalls openSides;

        /// <summary>Smoke that thins in 4 s in air of 20 °C, and leaves through every side but the floor.</summary>
        public static SmokeSettings Default => new SmokeSettings
        {
            lifetime = 4f,
            cooling = 3f,
            vorticity = 0.3f,
            airTemperature = 20f,
            steamTemperature = 60f,
            openSides = BoxWalls.All & ~BoxWalls.Bottom,
        };

        /// <summary>Puts every value into its range.</summary>
        /// <param name="problem">What was wrong and what it became; null if nothing was.</param>
        /// <returns>Whether the settings were valid as they stood.</returns>
        public bool Validate(out string problem)
        {
            problem = null;
            SmokeSettings usual = Default;
            Limit.Clamp("cell size", ref cellSize, 0f, 10f, usual.cellSize, ref problem);
            Limit.Clamp("lifetime", ref lifetime, 0f, 1000f, usual.lifetime, ref problem);
            Limit.Clamp("cooling", ref cooling, 0f, 1000f, usual.cooling, ref problem);
            Limit.Clamp("vorticity", ref vorticity, 0f, MaxVorticity, usual.vorticity, ref problem);
            Limit.Clamp("air temperature", ref airTemperature, -100f, 1000f, usual.airTemperature, ref problem);
            Limit.Clamp("steam", ref steam, 0f, MaxDensity, usual.steam, ref problem);
            Limit.Clamp("steam temperature", ref steamTemperature, -100f, MaxTemperature, usual.steamTemperature, ref problem);
            openSides &= BoxWalls.All;
            return problem == null;
        }
    }
}
