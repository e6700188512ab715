using System;
using NUnit.Framework;
using Unity.Mathematics;
using static System.FormattableString;

namespace Rill.Tests
{
    public class BordersTests
    {
        [TestCase(20f, 0f), TestCase(20f, 20f), TestCase(40f, 0f), TestCase(40f, 20f), TestCase(40f, 40f)]
        public void Study(float length, float width)
        {
            float amplitude = 3f;
            using (var tank = new WaveTank(length, 16, amplitude, width > 0f ? BorderKind.Absorbing : BorderKind.Wall, width))
            {
                (double incident, double reflected) = tank.Run();
                TestContext.WriteLine(Invariant($"length {length} band {width}: incident {incident:G4} reflected {100 * reflected:0.0} %"));
            }
        }
    }
}
