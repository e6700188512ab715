using System.Collections.Generic;
using UnityEngine;

namespace Fixtures
{
    /// <summary>Names what an optional stage needs, as the package's own stages do.</summary>
    public class Recipe : ScriptableObject
    {
        public ComputeShader sum;
        public Shader draw;
        public Recipe next;
        public List<ComputeShader> kernels;
        public float amount = 2;

        [System.NonSerialized] public bool nextWasReadWhenEnabled;

        void OnEnable() => nextWasReadWhenEnabled = next == null || next.amount != 2;
    }
}
