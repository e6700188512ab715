using System.Collections.Generic;
using System.Text;
using UnityEngine;

namespace Rill
{
    // Floating bodies in snapshots.
    public sealed partial class FluidSimulation
    {
        // A body of the snapshot with that of the scene; to is null where there is none.
        struct RestoredBody
        {
            public SnapshotBody from;
            public ICarriedBody to;
        }

        void SaveBodies(SnapshotContents contents, SnapshotCapture capture)
        {
            var saved = new List<SnapshotBody>();
            foreach (ICarriedBody carried in KnownBodies())
            {
                if (!carried.IsCarriedBy(this))
                    continue;
                var body = new SnapshotBody { path = CarriedBodies.PathOf(carried.Body), body = carried.Body };
                carried.Save(this, body, capture);
                saved.Add(body);
            }
            contents.Bodies = saved;
            capture.Finishing(() => contents.Set(SnapshotSection.Bodies, SnapshotBodies.Write(saved)));
        }

        // Those with a component of their own first, then those that this fluid carries by layer.
        List<ICarriedBody> KnownBodies()
        {
            var known = new List<ICarriedBody>(CarriedBodies.Enabled);
            (ColliderSource as IBodySource)?.ListBodies(known);
            return known;
        }

        // Puts them back, and says which are gone and which are new.
        List<RestoredBody> PlaceBodies(SnapshotContents contents, in BoxMotion box)
        {
            var restored = new List<RestoredBody>();
            if (contents.Bodies == null)
                return restored;        // of an older version, which knew of none
            List<ICarriedBody> known = KnownBodies();
            StringBuilder gone = null, still = null, fresh = null;
            foreach (SnapshotBody from in contents.Bodies)
            {
                ICarriedBody to = Find(from, known);
                if (to == null)
                    List(ref gone, from.path);
                else if (!to.Place(from, box))
                    List(ref still, from.path);
                known.Remove(to);
                restored.Add(new RestoredBody { from = from, to = to });
            }
            foreach (ICarriedBody other in known)
                if (other.IsCarriedBy(this))
                    List(ref fresh, CarriedBodies.PathOf(other.Body));
            WarnOf(gone, "The snapshot has floating bodies that the scene has not: ", "They are left out.");
            WarnOf(still, "Bodies that floated in the snapshot are kinematic: ", "They were put back, and have no velocity.");
            WarnOf(fresh, "Bodies float in the fluid that the snapshot has not: ", "They stay where they are, and begin there at rest.");
            return restored;
        }

        // The same object, else one of the same name: of several the first that is left.
        ICarriedBody Find(SnapshotBody from, List<ICarriedBody> known)
        {
            if (from.body != null)
            {
                foreach (ICarriedBody body in known)
                    if (ReferenceEquals(body.Body, from.body))
                        return body;
                return (ColliderSource as IBodySource)?.CarrierOf(from.body);
            }
            foreach (ICarriedBody body in known)
                if (body.Body != null && CarriedBodies.PathOf(body.Body) == from.path)
                    return body;
            return null;
        }

        void LoadBodies(List<RestoredBody> restored, in BoxMotion box)
        {
            foreach (RestoredBody body in restored)
                body.to?.Load(this, body.from, box);
        }

        static void List(ref StringBuilder names, string name)
        {
            names = names == null ? new StringBuilder() : names.Append(", ");
            names.Append('\'').Append(name).Append('\'');
        }

        void WarnOf(StringBuilder names, string what, string follows)
        {
            if (names != null)
                Debug.LogWarning($"Rill: FluidSimulation '{name}' was restored. {what}" + names.ToString() + ". " + follows, this);
        }
    }
}
