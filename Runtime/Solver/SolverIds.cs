using UnityEngine;

namespace Rill
{
    /// <summary>Names that Solver.hlsl gives to every stage.</summary>
    static class SolverIds
    {
        public static readonly int Constants = Shader.PropertyToID("RillSolver");
    }
}
