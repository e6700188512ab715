using static System.FormattableString;

namespace Rill
{
    /// <summary>A value for each phase: an array without an object of its own.</summary>
    struct PhaseValues
    {
        float v0, v1, v2, v3, v4, v5, v6, v7;

        public float this[int phase]
        {
            get
            {
                switch (phase)
                {
                    case 0: return v0;
                    case 1: return v1;
                    case 2: return v2;
                    case 3: return v3;
                    case 4: return v4;
                    case 5: return v5;
                    case 6: return v6;
                    case 7: return v7;
                    default:
                        throw Limit.OutOfRange(nameof(phase), phase,
                        Invariant($"Phase {phase}: phases are 0 to {PhaseMaterials.Phases - 1}."));
                }
            }
            set
            {
                switch (phase)
                {
                    case 0: v0 = value; break;
                    case 1: v1 = value; break;
                    case 2: v2 = value; break;
                    case 3: v3 = value; break;
                    case 4: v4 = value; break;
                    case 5: v5 = value; break;
                    case 6: v6 = value; break;
                    case 7: v7 = value; break;
                }
            }
        }
    }
}
