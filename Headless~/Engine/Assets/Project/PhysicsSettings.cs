using System.Globalization;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Assets
{
    /// <summary>Settings of DynamicsManager.asset for bodies: gravity, thresholds, when physics is stepped, which layers meet.</summary>
    internal static class PhysicsSettings
    {
        const int Layers = 32;

        public static void Apply(YamlNode settings)
        {
            Physics.gravity = BuiltInValues.Vector3(settings["m_Gravity"], Physics.gravity);
            Physics.bounceThreshold = settings.Float("m_BounceThreshold", Physics.bounceThreshold);
            Physics.sleepThreshold = settings.Float("m_SleepThreshold", Physics.sleepThreshold);
            Physics.defaultContactOffset = settings.Float("m_DefaultContactOffset", Physics.defaultContactOffset);
            Physics.defaultMaxAngularSpeed = settings.Float("m_DefaultMaxAngularSpeed", Physics.defaultMaxAngularSpeed);
            Physics.queriesHitBackfaces = settings.Bool("m_QueriesHitBackfaces", Physics.queriesHitBackfaces);
            Physics.queriesHitTriggers = settings.Bool("m_QueriesHitTriggers", Physics.queriesHitTriggers);
            // Older editors knew of stepping by scripts alone.
            int mode = settings.Int("m_SimulationMode", settings.Bool("m_AutoSimulation", true) ? (int)SimulationMode.FixedUpdate
                : (int)SimulationMode.Script);
            Physics.simulationMode = (SimulationMode)mode;
            ReadLayers(settings.Text("m_LayerCollisionMatrix"));
        }

        // 32 masks as hexadecimal text, each with its lowest byte first.
        static void ReadLayers(string matrix)
        {
            if (matrix == null || matrix.Length < 8 * Layers)
                return;
            for (int layer = 0; layer < Layers; layer++)
                for (int other = 0; other < Layers; other++)
                {
                    string text = matrix.Substring(8 * layer + other / 8 * 2, 2);
                    if (!byte.TryParse(text, NumberStyles.HexNumber, CultureInfo.InvariantCulture, out byte bits))
                        return;
                    CollisionLayers.Ignore(layer, other, (bits >> other % 8 & 1) == 0);
                }
        }
    }
}
