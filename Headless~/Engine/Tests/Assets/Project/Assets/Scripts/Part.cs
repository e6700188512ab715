using System.Collections.Generic;
using UnityEngine;

namespace Fixtures
{
    /// <summary>Tells in which order components woke and what they saw.</summary>
    public class Part : MonoBehaviour
    {
        public static readonly List<string> Log = new List<string>();

        public float size = 1;
        public Part partner;
        public List<int> counts;
        public List<Nozzle> nozzles;

        void Awake() => Log.Add("Awake " + name);
        void OnEnable() => Log.Add("OnEnable " + name);
    }
}
