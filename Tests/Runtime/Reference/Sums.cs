using System;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>A sum, and the sum of its terms' sizes: what single precision may lose is a fraction of the latter.</summary>
    struct Sum
    {
        public double value, size;

        public void Add(double term)
        {
            value += term;
            size += Math.Abs(term);
        }
    }

    /// <summary>Sum of vectors.</summary>
    struct VectorSum
    {
        public double3 value;
        public double size;

        public void Add(double3 term)
        {
            value += term;
            size += math.length(term);
        }
    }
}
