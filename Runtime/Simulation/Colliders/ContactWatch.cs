using System;
using UnityEngine;

namespace Rill
{
    /// <summary>Changes by a reading of the force on a collider.</summary>
    [Flags]
    enum ContactChange
    {
        None = 0,
        /// <summary>Water has come to it.</summary>
        Enter = 1,
        /// <summary>An impulse as large as the threshold.</summary>
        Hit = 2,
        /// <summary>Water has left it.</summary>
        Exit = 4,
    }

    /// <summary>Follows the readings of one fluid's force on one collider, and tells each change once.</summary>
    struct ContactWatch
    {
        /// <summary>Without any force, until the water has left, s: drops bounce.</summary>
        public const float QuietTime = 0.2f;

        /// <summary>Fraction of the threshold below which the next hit can come.</summary>
        public const float CalmFraction = 0.5f;

        bool touches, hits;
        float quiet;        // s
        WettedArea last;    // the last that there was
        bool wasWet;

        /// <summary>Whether water touches it.</summary>
        public bool Touches => touches;

        /// <summary>Puts all of it into a snapshot.</summary>
        public void Save(ref ForceRecord to)
        {
            to.flags |= (touches ? ForceRecord.Touches : 0) | (hits ? ForceRecord.Hits : 0) | (wasWet ? ForceRecord.WasWet : 0);
            to.quiet = quiet;
            to.lastWetted = last;
        }

        /// <summary>Returns a watch that goes on from a saved state.</summary>
        public static ContactWatch Of(in ForceRecord record) => new ContactWatch
        {
            touches = record.Has(ForceRecord.Touches),
            hits = record.Has(ForceRecord.Hits),
            wasWet = record.Has(ForceRecord.WasWet),
            quiet = record.quiet,
            last = record.lastWetted,
        };

        /// <summary>Returns what a reading says is wet, or where the last one was that did.</summary>
        /// <param name="position">Position of the collider, where there was none, m.</param>
        public WettedArea Follow(in WettedArea wetted, Vector3 position)
        {
            if (!(wetted.Area > 0f))
                return wasWet ? last.Dry : new WettedArea(0f, position, Vector3.zero);
            wasWet = true;
            last = wetted;
            return wetted;
        }

        /// <param name="impulse">Impulse of the reading, N s.</param>
        /// <param name="duration">Duration of its steps, s.</param>
        /// <param name="threshold">Threshold of a hit, N s, above 0.</param>
        public ContactChange Follow(float impulse, float duration, float threshold)
        {
            var change = ContactChange.None;
            if (impulse > 0f)
            {
                quiet = 0f;
                if (!touches)
                    change |= ContactChange.Enter;
                touches = true;
            }
            else if (touches && (quiet += duration) >= QuietTime)
            {
                touches = false;
                change |= ContactChange.Exit;
            }
            bool hit = impulse >= (hits ? CalmFraction * threshold : threshold);
            if (hit && !hits)
                change |= ContactChange.Hit;
            hits = hit;
            return change;
        }
    }
}
