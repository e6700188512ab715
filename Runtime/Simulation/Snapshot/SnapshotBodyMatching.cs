using System.Collections.Generic;
using System.Text;
using UnityEngine;

namespace Rill
{
    /// <summary>A body of a snapshot with that of the scene; <c>to</c> is null where there is none.</summary>
    struct RestoredBody
    {
        public SnapshotBody from;
        public ICarriedBody to;
    }

    /// <summary>Saves the floating bodies of a fluid in snapshots, and finds them again in the scene.</summary>
    sealed class SnapshotBodyMatching
    {
        readonly FluidSimulation fluid;

        public SnapshotBodyMatching(FluidSimulation fluid) => this.fluid = fluid;

        public void Save(SnapshotContents contents, SnapshotCapture capture)
        {
            var saved = new List<SnapshotBody>();
            foreach (ICarriedBody carried in KnownBodies())
            {
                if (!carried.IsCarriedBy(fluid))
                    continue;
                var body = new SnapshotBody { path = CarriedBodies.PathOf(carried.Body), body = carried.Body };
                carried.Save(fluid, body, capture);
                saved.Add(body);
            }
            contents.Bodies = saved;
            capture.Finishing(() => contents.Set(SnapshotSection.Bodies, SnapshotBodies.Write(saved)));
        }

        // Bodies with a component of their own come first, then those that this fluid carries by layer.
        List<ICarriedBody> KnownBodies()
        {
            var known = new List<ICarriedBody>(CarriedBodies.Enabled);
            (fluid.Inputs.Colliders.Source as IBodySource)?.ListBodies(known);
            return known;
        }

        /// <summary>Puts the bodies of a snapshot back, and logs which are gone and which are new.</summary>
        public List<RestoredBody> Restore(SnapshotContents contents, in BoxMotion box)
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
                else if (!to.Restore(from, box))
                    List(ref still, from.path);
                known.Remove(to);
                restored.Add(new RestoredBody { from = from, to = to });
            }
            foreach (ICarriedBody other in known)
                if (other.IsCarriedBy(fluid))
                    List(ref fresh, CarriedBodies.PathOf(other.Body));
            LogBodies(gone, "The snapshot has floating bodies that the scene has not: ", "They are left out.");
            LogBodies(still, "Bodies that floated in the snapshot are kinematic: ", "They were put back, and have no velocity.");
            LogBodies(fresh, "Bodies float in the fluid that the snapshot has not: ", "They stay where they are, and begin there at rest.");
            return restored;
        }

        // Returns the same object, or else one of the same name: the first that is left of several.
        ICarriedBody Find(SnapshotBody from, List<ICarriedBody> known)
        {
            if (from.body != null)
            {
                foreach (ICarriedBody body in known)
                    if (ReferenceEquals(body.Body, from.body))
                        return body;
                return (fluid.Inputs.Colliders.Source as IBodySource)?.CarrierOf(from.body);
            }
            foreach (ICarriedBody body in known)
                if (body.Body != null && CarriedBodies.PathOf(body.Body) == from.path)
                    return body;
            return null;
        }

        /// <summary>Loads how the fluid carries the bodies that were put back.</summary>
        public void Load(List<RestoredBody> restored, in BoxMotion box)
        {
            foreach (RestoredBody body in restored)
                body.to?.Load(fluid, body.from, box);
        }

        static void List(ref StringBuilder names, string name)
        {
            names = names == null ? new StringBuilder() : names.Append(", ");
            names.Append('\'').Append(name).Append('\'');
        }

        void LogBodies(StringBuilder names, string what, string follows)
        {
            if (names != null)
                Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}' was restored. {what}" + names.ToString() + ". " + follows, fluid);
        }
    }
}
